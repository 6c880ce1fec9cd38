#include "shapes.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <functional>
#include <numeric>

#include "meshknit/core/error.h"
#include "meshknit/surface/edge_path.h"
#include "meshknit/time_field/time_field.h"
#include "surface/test_meshes.h"

namespace meshknit {
namespace {

constexpr double pi = 3.14159265358979323846;

double smooth_step(double x) {
  x = std::clamp(x, 0.0, 1.0);
  return x * x * (3.0 - 2.0 * x);
}

// The marks of a tube whose vertices go from its start to its end.
std::vector<TimeMark> first_and_last(const VertexArray& vertices) {
  return {{-1.0, vertices.row(0).transpose()},
          {1.0, vertices.row(vertices.rows() - 1).transpose()}};
}

// An upright tube as an example: it starts at z = 0.
ExampleShape upright(const TubeShape& tube_shape) {
  const MeshArrays arrays = tube(tube_shape);
  return {arrays.vertices, arrays.faces, first_and_last(arrays.vertices), {}};
}

ExampleShape bottle() {
  return upright(
      {48, 40, 150.0, [](double z) { return 34.0 - 20.0 * smooth_step((z - 75.0) / 35.0); }});
}

ExampleShape hourglass() {
  return upright({40, 32, 120.0, [](double z) {
                    const double u = (z - 60.0) / 60.0;
                    return 20.0 + 18.0 * u * u;
                  }});
}

ExampleShape tilted_cut() {
  constexpr double radius = 30.0, middle = 100.0;
  const double slope = std::tan(pi / 6.0);
  ExampleShape shape = upright({40, 24, middle, [](double) { return radius; }});
  for (Eigen::Index v = 0; v < shape.vertices.rows(); ++v)
    shape.vertices(v, 2) *= 1.0 + slope * shape.vertices(v, 0) / middle;
  shape.times = first_and_last(shape.vertices);
  return shape;
}

// Sums of three waves with random heights and phases.
class Wave {
 public:
  explicit Wave(Jitter& jitter) {
    for (int k = 0; k < 3; ++k) {
      height_[k] = jitter.next() / (k + 1.0);
      phase_[k] = pi * jitter.next();
    }
  }
  double operator()(double angle) const {
    double sum = 0.0;
    for (int k = 0; k < 3; ++k) sum += height_[k] * std::sin((k + 1) * angle + phase_[k]);
    return sum;
  }

 private:
  std::array<double, 3> height_, phase_;
};

ExampleShape wobbly_tube() {
  constexpr int around = 40, along = 30;
  constexpr double length = 140.0;
  Jitter jitter(11);
  const Wave aside(jitter), ahead(jitter), width(jitter), section(jitter), twist(jitter);
  TubeShape straight{around, along, length, [](double) { return 1.0; }};
  ExampleShape shape = upright(straight);
  for (Eigen::Index v = 0; v < shape.vertices.rows(); ++v) {
    const double z = shape.vertices(v, 2), u = pi * z / length;
    const double angle = std::atan2(shape.vertices(v, 1), shape.vertices(v, 0));
    const double radius = 27.0 + 5.0 * width(u) + 3.0 * section(angle + twist(u));
    shape.vertices.row(v) << radius * shape.vertices(v, 0) + 12.0 * aside(u),
        radius * shape.vertices(v, 1) + 12.0 * ahead(u), z;
  }
  shape.times = first_and_last(shape.vertices);
  return shape;
}

struct NamedShape {
  const char* name;
  std::function<ExampleShape()> make;
};

const std::vector<NamedShape>& more_shapes() {
  static const std::vector<NamedShape> shapes = {
      {"bent_tube_30", [] { return bent_tube(30.0); }},
      {"bent_tube_60", [] { return bent_tube(60.0); }},
      {"bent_tube_120", [] { return bent_tube(120.0); }},
      {"widening_cone", [] { return cone(20.0, 45.0); }},
      {"bottle", bottle},
      {"hourglass", hourglass},
      {"tilted_cut", tilted_cut},
      {"wobbly_tube", wobbly_tube},
  };
  return shapes;
}

}  // namespace

std::vector<std::string> shape_names() {
  // By name, not by trying: every test program asks for this list before its first test.
  std::vector<std::string> names = {"straight_tube", "cone", "bent_tube", "sock"};
  for (const NamedShape& shape : more_shapes()) names.push_back(shape.name);
  return names;
}

ExampleShape arrays_of_shape(const std::string& name, double size) {
  const auto found = std::find_if(more_shapes().begin(), more_shapes().end(),
                                  [&](const NamedShape& shape) { return shape.name == name; });
  ExampleShape shape = found == more_shapes().end() ? example_shape(name) : found->make();
  return scaled(std::move(shape), size);
}

std::vector<TimeConstraint> time_constraints(const Surface& surface,
                                             const ExampleShape& shape) {
  std::vector<TimeConstraint> constraints;
  for (const TimeMark& mark : shape.times)
    constraints.push_back(
        {surface.boundaries[nearest_boundary(surface, mark.boundary_near)].vertices,
         mark.time});
  return constraints;
}

ExampleShape opened(ExampleShape shape, double stitch_width) {
  SurfaceOptions options;
  options.stitch_width = stitch_width;
  CutSurface cut = cut_openings(shape.vertices, shape.faces, {}, shape.openings, options);
  if (has_errors(cut.problems)) throw NotKnittable(cut.problems);
  shape.vertices = std::move(cut.vertices);
  shape.faces = std::move(cut.faces);
  for (TimeMark& mark : shape.times)
    if (mark.opening >= 0)
      mark = {mark.time,
              shape.vertices.row(cut.openings[mark.opening].rim.front()).transpose()};
  shape.openings.clear();
  return shape;
}

TimedShape timed(const ExampleShape& shape, double stitch_width) {
  SurfaceOptions options;
  options.stitch_width = stitch_width;
  TimedShape result;
  result.surface = make_surface(shape.vertices, shape.faces, options);
  if (has_errors(result.surface.problems)) throw NotKnittable(result.surface.problems);
  result.time = solve_time_field(result.surface, time_constraints(result.surface, shape)).time;
  return result;
}

TimedShape shape_named(const std::string& name, double size) {
  return timed(arrays_of_shape(name, size));
}

RemeshOptions gauge(double times) {
  RemeshOptions options;
  options.stitch_width *= times;
  options.stitch_height *= times;
  return options;
}

double smallest_angle(const ExampleShape& shape) {
  double smallest = pi;
  for (Eigen::Index f = 0; f < shape.faces.rows(); ++f)
    for (int k = 0; k < 3; ++k) {
      const auto corner = [&](int i) -> Eigen::Vector3d {
        return shape.vertices.row(shape.faces(f, (k + i) % 3)).transpose();
      };
      const Eigen::Vector3d a = corner(1) - corner(0), b = corner(2) - corner(0);
      smallest = std::min(smallest, std::atan2(a.cross(b).norm(), a.dot(b)));
    }
  return smallest * 180.0 / pi;
}

ExampleShape shuffled(const ExampleShape& shape, unsigned seed) {
  Jitter jitter(seed);
  const auto order = [&](Eigen::Index n) {
    std::vector<int> places(n);
    std::iota(places.begin(), places.end(), 0);
    for (Eigen::Index i = n - 1; i > 0; --i)
      std::swap(places[i], places[static_cast<int>(0.5 * (jitter.next() + 1.0) * (i + 1))]);
    return places;
  };
  ExampleShape result = shape;
  const std::vector<int> vertex = order(shape.vertices.rows());
  for (Eigen::Index v = 0; v < shape.vertices.rows(); ++v)
    result.vertices.row(vertex[v]) = shape.vertices.row(v);
  const std::vector<int> face = order(shape.faces.rows());
  for (Eigen::Index f = 0; f < shape.faces.rows(); ++f)
    for (int k = 0; k < 3; ++k) result.faces(face[f], k) = vertex[shape.faces(f, (k + f) % 3)];
  return result;
}

}  // namespace meshknit
