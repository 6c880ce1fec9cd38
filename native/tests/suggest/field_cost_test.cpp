#include "meshknit/suggest/field_cost.h"

#include <gtest/gtest.h>

#include "shapes.h"

namespace meshknit {
namespace {

FieldCost cost_of(const TimedShape& shape, const CostGauge& gauge = {}) {
  return cost_of_field(shape.surface, shape.time, gauge);
}

TEST(FieldCost, AStraightTubeNeedsNoShaping) {
  const FieldCost cost = cost_of(shape_named("straight_tube"));
  EXPECT_LT(cost.shaping + cost.short_rows + cost.flat, 1.0);
  EXPECT_EQ(cost.splits + cost.merges, 0);
  // Radius 30 mm: 2 pi 30 / 3.66 = 51 loops, half of them on each bed, two needles a loop; and the free
  // needles at both ends.
  EXPECT_NEAR(cost.needles, 51.0 + 8.0, 1.0);
}

TEST(FieldCost, AConeLosesTheStitchesOfItsGirth) {
  // From 2 pi 45 to 2 pi 20 mm: 157 mm, 43 stitches.
  EXPECT_NEAR(cost_of(shape_named("cone")).shaping, 43.0, 2.0);
}

TEST(FieldCost, ABendNeedsShortRowsAndMoreOfThemTheMoreItBends) {
  const double none = cost_of(shape_named("straight_tube")).short_rows;
  const double some = cost_of(shape_named("bent_tube_30")).short_rows;
  const double more = cost_of(shape_named("bent_tube")).short_rows;
  EXPECT_LT(none + 3.0, some);
  EXPECT_LT(2.0 * some, more);
}

TEST(FieldCost, CountsWhereTubesPartAndMeet) {
  const FieldCost ring = cost_of(timed(opened(example_shape("ring_torus"))));
  EXPECT_EQ(ring.splits, 1);
  EXPECT_EQ(ring.merges, 1);
  EXPECT_TRUE(ring.can_hang);
  const FieldCost three = cost_of(timed(opened(example_shape("three_way_split"))));
  EXPECT_EQ(three.splits, 2);
  EXPECT_EQ(three.ends, 3);
}

TEST(FieldCost, WhatIsTooWideForTheBedComesLast) {
  const TimedShape tube = shape_named("straight_tube");
  CostGauge narrow;
  narrow.needles = 50;
  const FieldCost cost = cost_of(tube, narrow);
  EXPECT_FALSE(cost.fits);
  EXPECT_GT(cost.total(), 1000.0 * cost_of(tube).total());
}

}  // namespace
}  // namespace meshknit
