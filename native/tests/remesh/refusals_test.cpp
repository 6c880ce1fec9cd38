// What remeshing cannot knit, and how it says so.

#include <gtest/gtest.h>

#include "meshknit/core/error.h"
#include "meshknit/remesh/remesh.h"
#include "meshknit/surface/blob_shape.h"
#include "shapes.h"

namespace meshknit {
namespace {

Problems refusal_of(const TimedShape& shape, const RemeshOptions& options = {}) {
  try {
    remesh(shape.surface, shape.time, options);
  } catch (const NotKnittable& refusal) {
    return refusal.problems();
  }
  return {};
}

// An upright tube of 25 mm radius with a closed spike of this radius and length on its side.
ExampleShape tube_with_spike(double radius, double length) {
  const Limb trunk = {{{0.0, 0.0, 0.0}, 25.0}, {{0.0, 0.0, 100.0}, 25.0}};
  Blobs blobs;
  blobs.rounding = 1.0;
  blobs.limbs = {trunk, {{{20.0, 0.0, 50.0}, radius}, {{25.0 + length, 0.0, 50.0}, radius}}};
  const Limb downward(trunk.rbegin(), trunk.rend());
  return shape_of_blobs(blobs, {{end_of(downward), -1.0}, {end_of(trunk), 1.0}}, 0.8 * radius);
}

TEST(Refusals, NameASpikeThatNoRowCanReach) {
  // 2.2 mm radius are 13.8 mm round: less than four stitches, over 45 mm. The graph is one
  // without the spike, or there is none; either way its place is named.
  const ExampleShape shape = tube_with_spike(2.2, 45.0);
  const TimedShape spiked = timed(shape);
  Problems problems = refusal_of(spiked);
  if (problems.empty()) remesh(spiked.surface, spiked.time, {}, nullptr, &problems);
  ASSERT_FALSE(problems.empty());
  const Problem& problem = problems.front();
  EXPECT_TRUE(problem.code == "splits-here" || problem.code == "part-left-out") << problem.code;
  EXPECT_FALSE(problem.remedy.empty());
  ASSERT_FALSE(problem.elements.faces.empty());
  // The spike stands out to the right of the tube, at half its height.
  for (const int face : problem.elements.faces)
    for (int k = 0; k < 3; ++k) {
      const Eigen::RowVector3d corner = shape.vertices.row(shape.faces(face, k));
      EXPECT_GT(corner.x(), 20.0);
      EXPECT_NEAR(corner.y(), 0.0, 10.0);
      EXPECT_NEAR(corner.z(), 50.0, 10.0);
    }
}

TEST(Refusals, AreSilentAboutATubeWithoutParts) {
  const TimedShape tube = shape_named("bent_tube");
  Problems problems;
  remesh(tube.surface, tube.time, {}, nullptr, &problems);
  EXPECT_TRUE(problems.empty());
}

TEST(Refusals, LeaveABluntKnobAlone) {
  EXPECT_TRUE(refusal_of(timed(tube_with_spike(10.0, 12.0))).empty());
}

TEST(Refusals, ASizeInTheWrongUnitIsNamedAsSuch) {
  // A tube of 60 m by 240 m.
  const Problems problems = refusal_of(shape_named("straight_tube", 2000.0));
  ASSERT_FALSE(problems.empty());
  EXPECT_EQ(problems.front().code, "too-many-stitches");
  EXPECT_NE(problems.front().remedy.find("millimetres"), std::string::npos);
}

TEST(Refusals, ARingTooLowForTwoRows) {
  // 2.4 mm; one row is 3.46 mm high.
  const ExampleShape low = straight_tube(30.0, 2.4);
  const Problems problems = refusal_of(timed(low));
  ASSERT_FALSE(problems.empty());
  EXPECT_EQ(problems.front().code, "too-flat");
}

}  // namespace
}  // namespace meshknit
