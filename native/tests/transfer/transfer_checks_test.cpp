#include "meshknit/transfer/transfer_checks.h"

#include <gtest/gtest.h>

#include "transfer/transfer_examples.h"

namespace meshknit {
namespace {

Place front(int n) { return {Bed::front, n, false}; }
Place back(int n) { return {Bed::back, n, false}; }
Place parked_front(int n) {
  return {Bed::back, n, true};
}  // a loop of the front, on the back bed

std::string code_of(const TransferProblem& problem, const std::vector<Transfer>& transfers) {
  TransferPlan plan;
  plan.transfers = transfers;
  const Problems found = check_transfer_plan(problem, plan);
  return found.empty() ? "" : found.front().code;
}

// Four loops a bed on places 0..3; the last front loop goes onto its left neighbour.
TransferProblem decrease_at_the_end() { return offsets({0, 0, 0, -1}, {0, 0, 0, 0}); }

TEST(TransferCheck, ParkingAndReturningDecreasesAtTheEnd) {
  EXPECT_EQ(code_of(decrease_at_the_end(),
                    {{front(3), parked_front(3)}, {parked_front(3), front(2)}}),
            "");
}

TEST(TransferCheck, AWrongRackingStacksStrangers) {
  // The loop should come back to its own hook, at racking 0; at -2 it comes down on its
  // neighbour.
  EXPECT_EQ(code_of(offsets({0, 0, 0, 0}, {0, 0, 0, 0}),
                    {{front(3), parked_front(3)}, {parked_front(3), front(2)}}),
            "stranger-stacked");
}

TEST(TransferCheck, TheRackingLimitHolds) {
  TransferProblem problem = decrease_at_the_end();
  problem.max_racking = 1;  // the return needs -2
  EXPECT_EQ(code_of(problem, {{front(3), parked_front(3)}, {parked_front(3), front(2)}}),
            "racking-limit");
}

TEST(TransferCheck, AForgottenReturnIsFound) {
  EXPECT_EQ(code_of(decrease_at_the_end(), {{front(3), parked_front(3)}}), "not-arrived");
  EXPECT_EQ(code_of(decrease_at_the_end(), {}), "not-arrived");
}

TEST(TransferCheck, AnEmptyNeedleHasNothingToGive) {
  EXPECT_EQ(code_of(decrease_at_the_end(), {{front(5), parked_front(5)}}),
            "transfer-from-empty");
}

TEST(TransferCheck, TransfersCrossBetweenTheBeds) {
  EXPECT_EQ(code_of(decrease_at_the_end(), {{front(3), front(2)}}), "same-bed-transfer");
}

TEST(TransferCheck, TheTubeKeepsToItsNeedles) {
  TransferProblem problem = decrease_at_the_end();
  problem.highest = 3;
  EXPECT_EQ(code_of(problem, {{front(3), parked_front(4)}}), "place-out-of-range");
}

TEST(TransferCheck, TheFirstLoopOfADecreaseLiesBelow) {
  // Loops 2 and 3 meet on place 3, where loop 3 already hangs: loop 2 must not come down on it
  // ...
  const TransferProblem problem = offsets({0, 0, 1, 0}, {0, 0, 0, 0});
  EXPECT_EQ(code_of(problem, {{front(2), parked_front(2)}, {parked_front(2), front(3)}}),
            "stack-order");
  // ... but loop 3 can make way and come back.
  EXPECT_EQ(code_of(problem, {{front(2), parked_front(2)},
                              {front(3), parked_front(3)},
                              {parked_front(2), front(3)},
                              {parked_front(3), front(3)}}),
            "");
}

TEST(TransferCheck, RackingStretchesTheBridgesAtTheEnds) {
  // Returning at racking 4: at the left end f0 and b1 are |0 - (1 + 4)| = 5 apart, their slack
  // is 3.
  const TransferProblem problem = offsets({0, 0, 0, 2}, {0, 0, 0, 0});
  TransferPlan plan;
  plan.transfers = {{front(3), parked_front(3)}, {parked_front(3), front(5)}};
  const Problems found = check_transfer_plan(problem, plan);
  ASSERT_EQ(found.size(), 1u);
  EXPECT_EQ(found.front().code, "slack-exceeded");
  EXPECT_EQ(found.front().elements.stitches, (std::vector<int>{7, 0}));
}

TEST(TransferCheck, LayoutsThatStretchTheYarnAreFoundAtRackingZero) {
  TransferProblem problem = offsets({0, 0}, {0, 0});
  problem.slack[0] = 1;  // neighbours on one bed hang 2 needles apart
  EXPECT_EQ(code_of(problem, {}), "slack-exceeded");
}

TEST(TransferCheck, NoLoopPassesItsNeighbour) {
  // With yarn enough, the first front loop is brought back right of the second one.
  TransferProblem problem = offsets({0, 0, 0, 0}, {0, 0, 0, 0});
  problem.slack.assign(8, 30);
  EXPECT_EQ(code_of(problem, {{front(0), parked_front(0)}, {parked_front(0), front(2)}}),
            "order-lost");
}

TEST(TransferCheck, OnlyTheOutermostLoopGoesRoundTheEnd) {
  TransferProblem problem = offsets({0, 0, 0, 0}, {0, 0, 0, 0});
  problem.slack.assign(8, 30);
  problem.max_racking = 9;
  // f4 to b9: the third loop overtakes the fourth.
  EXPECT_EQ(code_of(problem, {{front(2), back(4)}}), "order-lost");
  // f6 to b9: the fourth is outermost, only then it does not hang where it should.
  EXPECT_EQ(code_of(problem, {{front(3), back(4)}}), "not-arrived");
}

TEST(TransferCheck, ALoopThatGoesRoundLandsOutsideTheOthers) {
  TransferProblem problem = offsets({0, 0, 0}, {0, 0, 0});
  problem.slack.assign(6, 30);
  // The back's own last loop has been moved right by two; place 3 is inside of it.
  const Transfer out{back(2), {Bed::front, 2, true}}, in{{Bed::front, 2, true}, back(4)};
  EXPECT_EQ(code_of(problem, {out, in, {front(2), back(3)}}), "order-lost");
}

TEST(TransferCheck, ParkedLoopsStayOnTheirSide) {
  // From b0, where a front loop waits, to f1, where back loops wait.
  TransferProblem problem = offsets({0, 0, 0, 0}, {0, 0, 0, 0});
  problem.slack.assign(8, 30);
  EXPECT_EQ(
      code_of(problem, {{front(0), parked_front(0)}, {parked_front(0), {Bed::front, 0, true}}}),
      "parked-to-parked");
}

TEST(TransferCheck, AParkedLoopIsMeasuredWhereItHangs) {
  // Loop 3 parked on b6; racking 4 would bring it to 10 while its neighbour hangs on f4: 6
  // needles, and their slack is 2 * 1 + 1. All bridges are made long, so that only this pair
  // can complain.
  TransferProblem problem = offsets({0, 0, 0, -1}, {0, 0, 0, 0});
  problem.slack[3] = problem.slack[7] = 30;
  TransferPlan plan;
  plan.transfers = {{front(3), parked_front(3)}, {parked_front(3), front(5)}};
  const Problems found = check_transfer_plan(problem, plan);
  ASSERT_EQ(found.size(), 1u);
  EXPECT_EQ(found.front().code, "slack-exceeded");
  EXPECT_EQ(found.front().elements.stitches, (std::vector<int>{2, 3}));
}

}  // namespace
}  // namespace meshknit
