#include "meshknit/transfer/plan_transfers.h"

#include <gtest/gtest.h>

#include <algorithm>

#include "meshknit/core/error.h"
#include "meshknit/transfer/transfer_checks.h"
#include "transfer/transfer_examples.h"

namespace meshknit {
namespace {

// Plans, replays, and counts.
int planned_passes(const TransferProblem& problem) {
  EXPECT_TRUE(check_transfer_form(problem).empty());
  const TransferPlan plan = plan_transfers(problem);
  EXPECT_TRUE(check_transfer_plan(problem, plan).empty());
  return count_passes(plan);
}

std::vector<int> zeros(int count) { return std::vector<int>(count, 0); }
// `left` loops that stay, then `right` loops that move by `offset`.
std::vector<int> step(int left, int right, int offset) {
  std::vector<int> result = zeros(left);
  result.resize(left + right, offset);
  return result;
}

TEST(PlanTransfers, NothingToMoveTakesNoPass) {
  EXPECT_TRUE(plan_transfers(offsets(zeros(5), zeros(5))).transfers.empty());
}

TEST(PlanTransfers, ADecreaseAtTheEndMovesOneLoopTwice) {
  // Out to the parking needle and back onto the neighbour.
  const TransferPlan plan = plan_transfers(offsets({0, 0, 0, 0, -1}, zeros(5)));
  EXPECT_EQ(count_passes(plan), 2);
  EXPECT_EQ(plan.transfers.size(), 2u);
}

TEST(PlanTransfers, ADecreaseAnywhereOnTheFrontTakesTwoPasses) {
  // The loops right of it go out together and come back together, onto the loop that stayed.
  for (int place = 1; place < 12; ++place)
    EXPECT_EQ(planned_passes(offsets(step(place, 12 - place, -1), zeros(12))), 2) << place;
}

TEST(PlanTransfers, OnTheBackTheLoopThatStayedMustMakeWay) {
  // Anticlockwise the back runs leftward, so the loop that comes from the right lies below: the
  // one that it meets goes out as well and comes back later, a third pass.
  for (int place = 1; place < 12; ++place)
    EXPECT_EQ(planned_passes(offsets(zeros(12), step(place, 12 - place, -1))), 3) << place;
}

TEST(PlanTransfers, AGapMovesOnlyTheLoopsBesideIt) {
  const TransferPlan plan = plan_transfers(offsets(step(6, 4, 1), zeros(10)));
  EXPECT_EQ(count_passes(plan), 2);
  EXPECT_EQ(plan.transfers.size(), 8u);  // four loops, out and back
}

TEST(PlanTransfers, AShiftOfTheWholeTubeTakesThreePasses) {
  // Either bed needs a pass each way, first away from itself; the two beds can share one of
  // them.
  for (const int width : {6, 25, 100}) {
    const TransferPlan plan = plan_transfers(rolled(width, 0, 1));
    EXPECT_EQ(count_passes(plan), 3);
    EXPECT_EQ(plan.transfers.size(), 4u * width);  // every loop twice
  }
}

TEST(PlanTransfers, TheNumberOfLoopsDoesNotMatterForThePasses) {
  for (int count = 1; count <= 4; ++count) {
    EXPECT_EQ(planned_passes(spread_decreases(20, count)),
              planned_passes(spread_decreases(200, count)));
    EXPECT_EQ(planned_passes(spread_gaps(20, count)), planned_passes(spread_gaps(200, count)));
  }
}

TEST(PlanTransfers, ShapingOfBothBedsTakesAHandfulOfPasses) {
  // One by one, k shapings on each bed would take 2k times two passes or more.
  for (const int width : {8, 30, 200}) {
    for (int count = 1; count <= 4; ++count) {
      EXPECT_LE(planned_passes(spread_gaps(width, count)), 3 + count) << width;
      EXPECT_LE(planned_passes(spread_decreases(width, count)), 4 * count) << width;
    }
  }
}

TEST(PlanTransfers, LoopsGoRoundBothEnds) {
  for (const int width : {4, 15, 200}) {
    for (const int shift : {-1, 0, 1}) {
      for (const int loops : {-1, 1}) EXPECT_LE(planned_passes(rolled(width, loops, shift)), 8);
      for (const int loops : {-2, 2})
        EXPECT_LE(planned_passes(rolled(width, loops, shift)), 14);
    }
  }
}

TEST(PlanTransfers, LongShiftsGoInSteps) {
  // A pass moves loops by two places at most.
  EXPECT_EQ(planned_passes(rolled(20, 0, 2)), 3);
  EXPECT_LE(planned_passes(rolled(20, 0, 6)), 6);
  EXPECT_LE(planned_passes(rolled(20, 0, 40)), 45);
}

TEST(PlanTransfers, WhereTheListStartsDoesNotMatter) {
  TransferProblem problem = offsets({0, 0, 0, -1, -1}, {1, 0, 0, -1, -1});
  const int passes = planned_passes(problem);
  for (std::size_t i = 1; i < problem.loops.size(); ++i) {
    std::rotate(problem.loops.begin(), problem.loops.begin() + 1, problem.loops.end());
    std::rotate(problem.slack.begin(), problem.slack.begin() + 1, problem.slack.end());
    EXPECT_EQ(planned_passes(problem), passes) << "started at loop " << i;
  }
}

TEST(PlanTransfers, ThePlanIsTheSameEveryTime) {
  const TransferProblem problem = spread_decreases(30, 3);
  const TransferPlan once = plan_transfers(problem), again = plan_transfers(problem);
  ASSERT_EQ(once.transfers.size(), again.transfers.size());
  for (std::size_t i = 0; i < once.transfers.size(); ++i) {
    EXPECT_EQ(once.transfers[i].from, again.transfers[i].from);
    EXPECT_EQ(once.transfers[i].to, again.transfers[i].to);
  }
}

void expect_plans(std::uint64_t seed, int problems, int most_loops, int most_offset,
                  int most_rolls) {
  Lcg lcg(seed);
  TransferPlanner planner;
  for (int i = 0; i < problems; ++i) {
    const TransferProblem problem = random_problem(lcg, most_loops, most_offset, most_rolls);
    ASSERT_TRUE(check_transfer_form(problem).empty()) << i;
    TransferPlan plan;
    ASSERT_NO_THROW(plan = planner.plan(problem)) << i;
    ASSERT_TRUE(check_transfer_plan(problem, plan).empty()) << i;
  }
}

TEST(PlanTransfers, RandomShapingOfSmallTubes) { expect_plans(1, 3000, 6, 2, 0); }
TEST(PlanTransfers, RandomShapingOfWideTubes) { expect_plans(2, 150, 60, 3, 0); }
TEST(PlanTransfers, RandomShapingWithBedChanges) { expect_plans(3, 250, 4, 2, 2); }
TEST(PlanTransfers, RandomShapingOfWideTubesWithBedChanges) { expect_plans(4, 30, 40, 2, 1); }

TEST(PlanTransfers, TooShortAYarnIsTheModelersProblem) {
  TransferProblem problem = offsets(step(4, 4, 1), zeros(8));
  problem.slack[3] = 3;  // the gap is 4 needles wide
  try {
    plan_transfers(problem);
    FAIL() << "a gap wider than its yarn was planned";
  } catch (const NotKnittable& error) {
    ASSERT_NE(find_problem(error.problems(), "transfer-impossible"), nullptr);
    EXPECT_EQ(error.problems().front().elements.stitches, (std::vector<int>{3, 4}));
  }
}

TEST(PlanTransfers, WithoutRackingNothingMoves) {
  TransferProblem problem = offsets({0, 0, 0, -1}, zeros(4));
  problem.max_racking = 0;
  EXPECT_THROW(plan_transfers(problem), NotKnittable);
}

TEST(PlanTransfers, LoopsOutOfOrderAreAUsageMistake) {
  TransferProblem problem = offsets(zeros(4), zeros(4));
  std::swap(problem.loops[0], problem.loops[2]);
  EXPECT_THROW(plan_transfers(problem), InvalidInput);
}

}  // namespace
}  // namespace meshknit
