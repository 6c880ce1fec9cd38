#include "meshknit/surface/example_shapes.h"

#include <gtest/gtest.h>

#include <cmath>

#include "meshknit/core/error.h"
#include "meshknit/surface/surface.h"
#include "meshknit/time_field/time_field.h"
#include "shapes.h"

namespace meshknit {
namespace {

constexpr double pi = 3.14159265358979323846;

Surface surface_of(const ExampleShape& shape) {
  const ExampleShape open = opened(shape);
  return make_surface(open.vertices, open.faces);
}

class EveryExample : public testing::TestWithParam<std::string> {};
INSTANTIATE_TEST_SUITE_P(ExampleShapes, EveryExample, testing::ValuesIn(example_shape_names()),
                         [](const auto& shape) { return shape.param; });

TEST_P(EveryExample, IsOnePieceWithoutFaults) {
  const Surface surface = surface_of(example_shape(GetParam()));
  EXPECT_TRUE(surface.problems.empty());
  EXPECT_EQ(surface.components, 1);
}

TEST_P(EveryExample, HasATimeForEveryRimAndAFieldWithoutFalseEnds) {
  const ExampleShape shape = opened(example_shape(GetParam()));
  const Surface surface = surface_of(shape);
  const std::vector<TimeConstraint> constraints = time_constraints(surface, shape);
  EXPECT_TRUE(check_constraints(surface, constraints).empty());
  const TimeFieldCheck check = solve_time_field(surface, constraints).check;
  EXPECT_TRUE(check.problems.empty());
  EXPECT_EQ(check.extrema, 0);
  EXPECT_EQ(check.saddles, check.expected_saddles);
}

TEST_P(EveryExample, FitsTheBedAndIsKnitInReasonableTime) {
  // At half gauge a tube of n stitches takes n needles of each of two beds: n / 2 loops a bed,
  // every other needle. No level of the field may be longer than 250 stitches of 3.66 mm.
  const TimedShape shape = timed(opened(example_shape(GetParam())));
  const TriangleMesh& mesh = shape.surface.mesh;
  for (double level = -0.975; level < 1.0; level += 0.05) {
    double length = 0.0;
    for (const auto face : mesh.faces()) {
      std::vector<Eigen::Vector3d> ends;
      for (const auto half : face.halfedges()) {
        const double from = shape.time[half.from().idx()] - level;
        const double to = shape.time[half.to().idx()] - level;
        if ((from < 0.0) != (to < 0.0))
          ends.push_back(mesh.point(half.from()) +
                         from / (from - to) *
                             (mesh.point(half.to()) - mesh.point(half.from())));
      }
      if (ends.size() == 2) length += (ends[1] - ends[0]).norm();
    }
    EXPECT_LE(length, 250.0 * 3.66) << "at time " << level;
  }
  // A node is one stitch wide and two courses high.
  const double nodes = shape.surface.area / (3.66 * 2.0 * 1.73);
  EXPECT_GE(nodes, 1400.0);
  EXPECT_LE(nodes, 6000.0);
}

TEST(ExampleShapes, BranchAsTheirNamesSay) {
  struct Branching {
    const char* name;
    int starts, between, ends, genus;
  };
  for (const Branching& expected :
       {Branching{"sock", 1, 0, 1, 0}, Branching{"two_way_split", 1, 0, 2, 0},
        Branching{"three_way_split", 1, 0, 3, 0}, Branching{"two_way_merge", 2, 0, 1, 0},
        Branching{"three_way_merge", 3, 0, 1, 0}, Branching{"trousers", 1, 0, 2, 0},
        Branching{"mitten", 1, 1, 1, 0}, Branching{"ring_torus", 1, 0, 1, 1},
        Branching{"teddy", 2, 2, 2, 0}}) {
    SCOPED_TRACE(expected.name);
    const ExampleShape shape = example_shape(expected.name);
    const Surface surface = surface_of(shape);
    int starts = 0, between = 0, ends = 0;
    for (const TimeMark& mark : shape.times)
      ++(mark.time == -1.0 ? starts : mark.time == 1.0 ? ends : between);
    EXPECT_EQ(starts, expected.starts);
    EXPECT_EQ(between, expected.between);
    EXPECT_EQ(ends, expected.ends);
    EXPECT_EQ(surface.genus, expected.genus);
    EXPECT_EQ(surface.boundaries.size(), shape.times.size());
  }
}

TEST(ExampleShapes, HaveTrianglesWithoutSlivers) {
  // Half the smallest angle of a good triangle is still far from what rounding can upset.
  for (const std::string& name : example_shape_names())
    EXPECT_GT(smallest_angle(example_shape(name)), 10.0) << name;
}

TEST(ExampleShapes, GrowWithTheirMarks) {
  const ExampleShape drawn = trousers(), larger = scaled(trousers(), 2.0);
  EXPECT_NEAR(surface_of(larger).area, 4.0 * surface_of(drawn).area, 1e-3);
  EXPECT_EQ(larger.times[1].boundary_near, 2.0 * drawn.times[1].boundary_near);
  EXPECT_EQ(scaled(teddy(), 2.0).openings[0].radius, 2.0 * teddy().openings[0].radius);
}

TEST(ExampleShapes, FaceOutwards) {
  // The volume under faces that point out is positive, with the flat openings left out of
  // account.
  for (const std::string& name : example_shape_names()) {
    const ExampleShape shape = example_shape(name);
    const Eigen::RowVector3d middle = shape.vertices.colwise().mean();
    double volume = 0.0;
    for (Eigen::Index f = 0; f < shape.faces.rows(); ++f) {
      const auto corner = [&](int k) -> Eigen::Vector3d {
        return (shape.vertices.row(shape.faces(f, k)) - middle).transpose();
      };
      volume += corner(0).dot(corner(1).cross(corner(2))) / 6.0;
    }
    EXPECT_GT(volume, 0.0) << name;
  }
}

TEST(ExampleShapes, HaveTheSizesThatTheyWereAskedFor) {
  // A circle of 40 corners is 0.1 % shorter than a round one.
  EXPECT_NEAR(surface_of(straight_tube(30.0, 120.0)).area, 2.0 * pi * 30.0 * 120.0, 50.0);
  const Surface shape = surface_of(cone(45.0, 20.0, 120.0));
  EXPECT_NEAR(shape.area, pi * (45.0 + 20.0) * std::hypot(25.0, 120.0), 60.0);
  // Pappus: a bend's area is its circumference times the length of its centre line.
  const double centre_line = 2.0 * 50.0 + 50.0 * pi / 2.0;
  EXPECT_NEAR(surface_of(bent_tube(90.0, 25.0, 50.0)).area, 2.0 * pi * 25.0 * centre_line,
              150.0);
}

TEST(ExampleShapes, UnknownOnesAndImpossibleBendsAreRefused) {
  EXPECT_THROW(example_shape("glove"), InvalidInput);
  EXPECT_THROW(bent_tube(-1.0), InvalidInput);
  EXPECT_THROW(bent_tube(151.0), InvalidInput);
}

}  // namespace
}  // namespace meshknit
