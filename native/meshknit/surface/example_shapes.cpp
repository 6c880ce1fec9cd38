#include "meshknit/surface/example_shapes.h"

#include <algorithm>
#include <cmath>
#include <functional>

#include "meshknit/core/error.h"

namespace meshknit {
namespace {

constexpr double pi = 3.14159265358979323846;
constexpr double ring_spacing = 5.0;  // mm along the centre line
constexpr int ring_points = 40;

// A ring of a tube: its centre in the xz plane, the direction of travel as an angle from -z
// towards +x, and the radii in and across that plane. `heel` pushes the outer side of a bend
// further out.
struct Ring {
  double x = 0.0, z = 0.0, heading = 0.0;
  double radius_in_plane = 0.0, radius_across = 0.0;
  double heel = 0.0;
};

ExampleShape skin_rings(const std::vector<Ring>& rings) {
  ExampleShape shape;
  const int n = static_cast<int>(rings.size());
  shape.vertices.resize(n * ring_points, 3);
  for (int i = 0; i < n; ++i) {
    const Ring& ring = rings[i];
    const Eigen::Vector3d outer(-std::cos(ring.heading), 0.0, -std::sin(ring.heading));
    const Eigen::Vector3d across(0.0, 1.0, 0.0);
    for (int j = 0; j < ring_points; ++j) {
      const double angle = 2.0 * pi * j / ring_points;
      const double out = std::cos(angle);
      const double bulge = ring.heel * std::pow(std::max(0.0, out), 2.0);
      shape.vertices.row(i * ring_points + j) =
          (Eigen::Vector3d(ring.x, 0.0, ring.z) + outer * (ring.radius_in_plane * out + bulge) +
           across * (ring.radius_across * std::sin(angle)))
              .transpose();
    }
  }
  shape.faces.resize(2 * (n - 1) * ring_points, 3);
  int face = 0;
  for (int i = 0; i + 1 < n; ++i)
    for (int j = 0; j < ring_points; ++j) {
      const int a = i * ring_points + j, b = i * ring_points + (j + 1) % ring_points;
      const int c = a + ring_points, d = b + ring_points;
      // Alternating diagonals keep the mesh from leaning to one side.
      if ((i + j) % 2 == 0) {
        shape.faces.row(face++) << a, b, c;
        shape.faces.row(face++) << b, d, c;
      } else {
        shape.faces.row(face++) << a, d, c;
        shape.faces.row(face++) << a, b, d;
      }
    }
  shape.times = {{-1.0, shape.vertices.row(0).transpose()},
                 {1.0, shape.vertices.row((n - 1) * ring_points).transpose()}};
  return shape;
}

// Walks a centre line of length `length`; `bend(s)` is the curvature at s, towards +x.
std::vector<Ring> centre_line(double length, const std::function<double(double)>& bend) {
  const int steps = std::max(2, static_cast<int>(std::lround(length / ring_spacing)));
  constexpr int substeps = 20;
  const double h = length / (steps * substeps);
  std::vector<Ring> rings;
  Ring at;
  rings.push_back(at);
  for (int i = 0; i < steps; ++i) {
    for (int k = 0; k < substeps; ++k) {
      const double s = (i * substeps + k + 0.5) * h;
      at.heading += 0.5 * h * bend(s);
      at.x += h * std::sin(at.heading);
      at.z -= h * std::cos(at.heading);
      at.heading += 0.5 * h * bend(s);
    }
    rings.push_back(at);
  }
  return rings;
}

double blend(double from, double to, double x) {
  x = std::clamp(x, 0.0, 1.0);
  return from + (to - from) * x * x * (3.0 - 2.0 * x);
}

ExampleShape straight_stub(double start_radius, double end_radius, double height) {
  std::vector<Ring> rings = centre_line(height, [](double) { return 0.0; });
  for (Ring& ring : rings) {
    const double u = -ring.z / height;
    ring.radius_in_plane = ring.radius_across = start_radius + (end_radius - start_radius) * u;
  }
  ExampleShape shape = skin_rings(rings);
  // The centre line runs down; turn the shape (not mirror it) so that it stands on its start.
  const Eigen::DiagonalMatrix<double, 3> turn(-1.0, 1.0, -1.0);
  shape.vertices = shape.vertices * turn;
  for (TimeMark& mark : shape.times) mark.boundary_near = turn * mark.boundary_near;
  return shape;
}

}  // namespace

ExampleShape straight_tube(double radius, double length) {
  return straight_stub(radius, radius, length);
}

ExampleShape cone(double start_radius, double end_radius, double height) {
  return straight_stub(start_radius, end_radius, height);
}

ExampleShape bent_tube(double degrees, double radius, double leg) {
  if (!(degrees >= 0.0 && degrees <= 150.0))
    throw InvalidInput("the angle of a bent tube must lie between 0 and 150 degrees");
  const double bend_radius = 2.0 * radius;
  const double arc = degrees * pi / 180.0 * bend_radius;
  std::vector<Ring> rings = centre_line(2.0 * leg + arc, [&](double s) {
    return s > leg && s < leg + arc ? 1.0 / bend_radius : 0.0;
  });
  for (Ring& ring : rings) ring.radius_in_plane = ring.radius_across = radius;
  return skin_rings(rings);
}

ExampleShape sock() {
  // Millimetres along the centre line: cuff, ankle, heel (a bend of 100 degrees), instep, ball, toe.
  constexpr double ankle = 85.0, heel_begin = 100.0, heel_end = 205.0, ball = 275.0,
                   toe = 330.0;
  constexpr double turn = 100.0 * pi / 180.0;
  // The curvature rises and falls smoothly over the heel and integrates to the turn. Its radius stays larger than
  // the sock's, so that the instep does not fold.
  const auto bend = [&](double s) {
    if (s <= heel_begin || s >= heel_end) return 0.0;
    const double u = (s - heel_begin) / (heel_end - heel_begin);
    return 0.5 * pi * turn / (heel_end - heel_begin) * std::sin(pi * u);
  };
  std::vector<Ring> rings = centre_line(toe, bend);
  for (std::size_t i = 0; i < rings.size(); ++i) {
    Ring& ring = rings[i];
    const double s = toe * static_cast<double>(i) / static_cast<double>(rings.size() - 1);
    double radius = blend(37.0, 29.0, s / ankle);
    if (s > ankle) radius = blend(29.0, 31.0, (s - ankle) / (heel_begin - ankle));
    if (s > heel_end) radius = blend(31.0, 29.0, (s - heel_end) / (ball - heel_end));
    if (s > ball) radius = blend(29.0, 13.0, (s - ball) / (toe - ball));
    // The foot is wider than high.
    const double flat =
        s > heel_end ? blend(1.0, 0.8, (s - heel_end) / (ball - heel_end)) : 1.0;
    ring.radius_across = radius / std::sqrt(flat);
    ring.radius_in_plane = radius * std::sqrt(flat);
    const double from_heel = (s - 0.5 * (heel_begin + heel_end)) / 34.0;
    ring.heel = 14.0 * std::exp(-from_heel * from_heel);
  }
  return skin_rings(rings);
}

ExampleShape scaled(ExampleShape shape, double size) {
  shape.vertices *= size;
  for (TimeMark& mark : shape.times) mark.boundary_near *= size;
  for (OpeningMark& opening : shape.openings) {
    opening.at *= size;
    opening.radius *= size;
  }
  return shape;
}

namespace {

struct NamedShape {
  const char* name;
  ExampleShape (*make)();
};

constexpr NamedShape named_shapes[] = {
    {"straight_tube", [] { return straight_tube(); }},
    {"cone", [] { return cone(); }},
    {"bent_tube", [] { return bent_tube(); }},
    {"sock", sock},
    {"two_way_split", two_way_split},
    {"three_way_split", three_way_split},
    {"two_way_merge", two_way_merge},
    {"three_way_merge", three_way_merge},
    {"trousers", trousers},
    {"mitten", mitten},
    {"ring_torus", ring_torus},
    {"teddy", teddy},
};

}  // namespace

std::vector<std::string> example_shape_names() {
  std::vector<std::string> names;
  for (const NamedShape& shape : named_shapes) names.push_back(shape.name);
  return names;
}

ExampleShape example_shape(const std::string& name) {
  for (const NamedShape& shape : named_shapes)
    if (name == shape.name) return shape.make();
  throw InvalidInput("no example shape is called \"" + name + "\"");
}

}  // namespace meshknit
