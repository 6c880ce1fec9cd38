#include "meshknit/transfer/turning.h"

#include <gtest/gtest.h>

#include "meshknit/transfer/plan_transfers.h"
#include "meshknit/transfer/transfer_checks.h"
#include "transfer/transfer_examples.h"

namespace meshknit {
namespace {

TransferProblem turned_by(int width, int loops) {
  TransferProblem problem = rolled(width, loops, 0);
  problem.lowest -= 2;  // room for a turn
  problem.highest += 2;
  return problem;
}

int planned_passes(const TransferProblem& problem) {
  const TransferPlan plan = plan_transfers(problem);
  EXPECT_TRUE(check_transfer_plan(problem, plan).empty());
  return count_passes(plan);
}

TEST(Turning, ATubeTurnsByTwoLoopsInSixPasses) {
  // Two loops round either end, each alone in its pass, and the beds past each other: once out,
  // once back.
  PairWaysCache cache;
  for (const int loops : {5, -5, 12, -12}) {
    const Tube tube = make_tube(turned_by(30, loops));
    const std::optional<PassPlan> turn = turn_by_two(tube, cache);
    ASSERT_TRUE(turn) << loops;
    EXPECT_EQ(turn->passes.size(), 6u) << loops;
    Tube after = tube;
    TransferPlan plan;
    advance(after, *turn, plan);
    int before_rolls = 0, after_rolls = 0;
    for (const Stack& stack : tube.stacks) before_rolls += std::abs(stack.roll());
    for (const Stack& stack : after.stacks) after_rolls += std::abs(stack.roll());
    EXPECT_EQ(before_rolls - after_rolls, 4) << loops;
  }
}

TEST(Turning, ALongWayRoundTakesThreePassesALoop) {
  for (const int width : {12, 40})
    for (const int loops : {4, 8, 10})
      for (const int way : {loops, -loops})
        EXPECT_LE(planned_passes(turned_by(width, way)), 3 * loops + 4) << width << " " << way;
}

TEST(Turning, FewLoopsAreLeftToOtherPlans) {
  PairWaysCache cache;
  for (const int loops : {1, 2})
    EXPECT_FALSE(turn_by_two(make_tube(turned_by(20, loops)), cache)) << loops;
}

}  // namespace
}  // namespace meshknit
