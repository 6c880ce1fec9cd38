#include "meshknit/surface/example_shapes.h"

#include <gtest/gtest.h>

#include <cmath>

#include "meshknit/core/error.h"
#include "meshknit/surface/edge_path.h"
#include "meshknit/surface/surface.h"

namespace meshknit {
namespace {

constexpr double pi = 3.14159265358979323846;

Surface surface_of(const ExampleShape& shape) {
  return make_surface(shape.vertices, shape.faces);
}

TEST(ExampleShapes, AreTubesWithoutFaults) {
  for (const std::string& name : example_shape_names()) {
    SCOPED_TRACE(name);
    const ExampleShape shape = example_shape(name);
    const Surface surface = surface_of(shape);
    EXPECT_TRUE(surface.problems.empty());
    EXPECT_EQ(surface.boundaries.size(), 2u);
    EXPECT_EQ(surface.genus, 0);
    EXPECT_NE(nearest_boundary(surface, shape.start), nearest_boundary(surface, shape.end));
  }
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
