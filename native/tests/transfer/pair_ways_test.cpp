#include "meshknit/transfer/pair_ways.h"

#include <gtest/gtest.h>

#include <algorithm>

#include "meshknit/transfer/pass_sequences.h"
#include "transfer/exact_search.h"
#include "transfer/transfer_examples.h"

namespace meshknit {
namespace {

constexpr int racking = 4, slack = 3;

Stack stack(int side, int place, int goal_side, int goal) {
  return {side, place, goal_side, goal, slack};
}

int passes(const Stack& a, const Stack& b) { return PairWays(a, b, 0, racking).passes_home(0); }

TEST(PairWays, ThoseAtHomeNeedNoPass) {
  EXPECT_EQ(passes(stack(0, 3, 0, 3), stack(0, 4, 0, 4)), 0);
}

TEST(PairWays, OnTheFrontTheRightLoopComesDownOnTheLeft) {
  EXPECT_EQ(passes(stack(0, 3, 0, 3), stack(0, 4, 0, 3)), 2);  // out and back
}

TEST(PairWays, ALoopThatStayedMakesWayForTheOneBelowIt) {
  // Anticlockwise the back runs leftward: the right one lies below, so the other goes out with it
  // and comes back later.
  EXPECT_EQ(passes(stack(1, 4, 1, 3), stack(1, 3, 1, 3)), 3);
}

TEST(PairWays, OneRollIsOnePass) {
  EXPECT_EQ(passes(stack(0, 4, 1, 4), stack(1, 4, 1, 3)), 2 + 1);
  // Only the first has to move: it hangs at the right end and finds an empty hook.
  EXPECT_EQ(passes(stack(0, 5, 1, 4), stack(1, 3, 1, 3)), 1);
}

TEST(PairWays, AGapWiderThanItsYarnIsNoWay) {
  EXPECT_EQ(passes(stack(0, 3, 0, 3), stack(0, 4, 0, 5)), PairWays::far);
}

TEST(PairWays, TheBoundIsNeverAboveTheShortestPlan) {
  Lcg lcg(5);
  PairWaysCache cache;
  for (int i = 0; i < 150; ++i) {
    const TransferProblem problem = random_problem(lcg, 3, 1, i % 2);
    const int least = PassSequences(make_tube(problem), cache).least_length();
    // A plan with fewer passes than the bound would be found.
    // Two loops have no order round the tube: they may also change places the other way.
    if (least > 4 || problem.loops.size() < 3) continue;
    EXPECT_EQ(fewest_passes(problem, least), least);
  }
}

TEST(PairWays, WhatIsRememberedIsWhatIsWorkedOut) {
  // Elsewhere on the bed, and on another turn round the tube.
  PairWaysCache cache;
  const PairWays& here = cache.ways(stack(0, 3, 0, 3), stack(0, 4, 0, 3), 0, racking);
  const PairWays& there = cache.ways(stack(2, 90, 2, 90), stack(2, 91, 2, 90), 0, racking);
  EXPECT_EQ(&here, &there);
  const PairWays& back = cache.ways(stack(1, 4, 1, 3), stack(1, 3, 1, 3), 0, racking);
  EXPECT_NE(&here, &back);
}

}  // namespace
}  // namespace meshknit
