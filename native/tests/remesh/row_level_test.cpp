#include "meshknit/remesh/row_level.h"

#include <gtest/gtest.h>

#include "meshknit/remesh/knit_limits.h"

namespace meshknit {
namespace {

TEST(RowLevel, IsEverywhereAsHighAsItShouldBe) {
  const RowLevel level = RowLevel::of_height(3.5);
  EXPECT_EQ(level.height(0, 0.0), 3.5);
  EXPECT_EQ(level.height(1, 40.0), 3.5);
}

TEST(RowLevel, SharesOutTheRestOfTheWay) {
  SweepPlan plan;
  plan.to_end = {4.0, 9.0, 100.0};
  const RowLevel level = RowLevel::part_of_rest(3, 3.5, plan);
  // 2 mm up and 4 to go are 6, a third is 2; 0 + 9 likewise 3; the last is capped.
  EXPECT_DOUBLE_EQ(level.height(0, 2.0), 2.0);
  EXPECT_DOUBLE_EQ(level.height(1, 0.0), 3.0);
  EXPECT_DOUBLE_EQ(level.height(2, 2.0), 3.5);
}

TEST(RowLevel, LeavesLaterPlacesForLaterRows) {
  PeelState state;
  state.time = {0.1, 0.3};
  const RowLevel level = RowLevel::of_height(3.5).not_later_than(0.2, state);
  EXPECT_EQ(level.height(0, 1.0), 3.5);
  EXPECT_EQ(level.height(1, 1.0), 0.0);
}

TEST(KnitLimits, OpenOneRegionAndNoOther) {
  SweepPlan plan;  // two tubes and the place between them
  plan.reeb.arcs.resize(2);
  plan.reeb.events.resize(1);
  plan.region = {0, 1, plan.event_region(0)};
  KnitLimits limits(plan);
  limits.open(1);
  EXPECT_FALSE(limits.may_knit(0));
  EXPECT_TRUE(limits.may_knit(1));
  EXPECT_FALSE(limits.must_knit(1));
  limits.finish(plan.event_region(0));
  EXPECT_TRUE(limits.may_knit(2));
  EXPECT_TRUE(limits.must_knit(2));
  limits.close_all();
  for (const int vertex : {0, 1, 2}) {
    EXPECT_FALSE(limits.may_knit(vertex));
    EXPECT_FALSE(limits.must_knit(vertex));
  }
}

}  // namespace
}  // namespace meshknit
