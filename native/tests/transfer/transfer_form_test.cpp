#include <gtest/gtest.h>

#include <algorithm>

#include "meshknit/transfer/transfer_checks.h"
#include "transfer/transfer_examples.h"

namespace meshknit {
namespace {

TransferProblem still(const std::vector<Hanging>& tube) { return moving(tube, tube); }

TEST(TransferForm, UsualSlackIsTheLongerDistanceAndOneNeedle) {
  // Front 0 and 1 spread to 0 and 3: 3 places, 7 needles. Front 1 -> 3 against back 1: 2
  // places, 5 needles. Back 1 and 0 stay neighbours: 3 needles. Back 0 faces front 0: at least
  // one place, 3 needles.
  const TransferProblem problem = offsets({0, 2}, {0, 0});
  EXPECT_EQ(problem.slack, (std::vector<int>{7, 5, 3, 3}));
}

TEST(TransferForm, ATubeMayStartAnywhere) {
  std::vector<Hanging> tube = tube_of(0, 4, 1, 3);
  for (std::size_t i = 0; i < tube.size(); ++i) {
    EXPECT_TRUE(check_transfer_form(still(tube)).empty()) << "started at loop " << i;
    std::rotate(tube.begin(), tube.begin() + 1, tube.end());
  }
}

TEST(TransferForm, ATubeMayHangOnOneBed) {
  EXPECT_TRUE(
      check_transfer_form(still({{Bed::front, 2}, {Bed::front, 5}, {Bed::front, 0}})).empty());
  EXPECT_TRUE(check_transfer_form(still({{Bed::back, 2}})).empty());
}

TEST(TransferForm, AClockwiseTubeIsRefused) {
  std::vector<Hanging> tube = tube_of(0, 4, 0, 4);
  std::reverse(tube.begin(), tube.end());
  EXPECT_TRUE(has_errors(check_transfer_form(still(tube))));
}

TEST(TransferForm, SwappedTargetsAreRefused) {
  TransferProblem problem = still(tube_of(0, 4, 0, 4));
  std::swap(problem.loops[1].to, problem.loops[2].to);
  EXPECT_TRUE(has_errors(check_transfer_form(problem)));
}

TEST(TransferForm, TwoLoopsOnOneHookAreRefused) {
  TransferProblem problem = still(tube_of(0, 4, 0, 4));
  problem.loops[2].from = 1;
  const Problems found = check_transfer_form(problem);
  ASSERT_TRUE(has_errors(found));
  EXPECT_EQ(found.front().elements.stitches, (std::vector<int>{1, 2}));
}

TEST(TransferForm, TargetsOutsideTheRangeAreRefused) {
  TransferProblem problem = still(tube_of(0, 4, 0, 4));
  problem.highest = 3;
  EXPECT_TRUE(has_errors(check_transfer_form(problem)));
}

TEST(TransferForm, EveryPairNeedsItsSlack) {
  TransferProblem problem = still(tube_of(0, 4, 0, 4));
  problem.slack.pop_back();
  EXPECT_TRUE(has_errors(check_transfer_form(problem)));
}

}  // namespace
}  // namespace meshknit
