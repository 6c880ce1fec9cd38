#include "meshknit/transfer/collapse_shift_expand.h"

#include <gtest/gtest.h>

#include <algorithm>

#include "meshknit/transfer/transfer_checks.h"
#include "transfer/textbook_planner.h"
#include "transfer/transfer_examples.h"

namespace meshknit {
namespace {

std::vector<int> zeros(int count) { return std::vector<int>(count, 0); }
std::vector<int> step(int left, int right, int offset) {
  std::vector<int> result = zeros(left);
  result.resize(left + right, offset);
  return result;
}

TransferPlan whole_plan(const TransferProblem& problem) {
  const TextbookPlan textbook = collapse_shift_expand_alone(problem);
  EXPECT_TRUE(textbook.arrived);
  EXPECT_TRUE(check_transfer_plan(problem, textbook.plan).empty());
  return textbook.plan;
}

TEST(CollapseShiftExpand, AShiftIsOneCollapseOneShiftOneExpansion) {
  // Every loop goes over and back, whatever the width.
  for (const int width : {5, 40}) {
    const TransferPlan plan = whole_plan(rolled(width, 0, 1));
    EXPECT_EQ(count_passes(plan), 3);
    EXPECT_EQ(plan.transfers.size(), 4u * width);
  }
}

TEST(CollapseShiftExpand, AGapTakesTheWholeTubeAlong) {
  // The loops right of it go over at one racking, the others at another; then a shift and an
  // expansion.
  for (const bool on_front : {true, false}) {
    const std::vector<int> gap = step(6, 6, 1), still = zeros(12);
    const TransferPlan plan = whole_plan(on_front ? offsets(gap, still) : offsets(still, gap));
    EXPECT_EQ(count_passes(plan), 4);
    EXPECT_EQ(plan.transfers.size(), 48u);
  }
}

TEST(CollapseShiftExpand, WidthDoesNotMatterForThePasses) {
  for (const int turn : {-2, -1, 1, 2})
    EXPECT_EQ(count_passes(whole_plan(rolled(12, turn, 0))),
              count_passes(whole_plan(rolled(120, turn, 0))));
  for (int count = 1; count <= 3; ++count)
    EXPECT_EQ(count_passes(whole_plan(spread_gaps(24, count))),
              count_passes(whole_plan(spread_gaps(240, count))));
}

TEST(CollapseShiftExpand, AQuarterTurnIsWalkedLoopByLoop) {
  // Half of each bed goes round an end.
  const TransferProblem problem = rolled(20, 10, 0);
  EXPECT_GE(count_passes(whole_plan(problem)), 10);
}

TEST(CollapseShiftExpand, EveryIterationEndsWhereTheTubeCanBeKnit) {
  // What follows may rack either way, so no yarn may be stretched at racking 0.
  Lcg lcg(7);
  for (int i = 0; i < 300; ++i) {
    const TransferProblem problem = random_problem(lcg, 12, 2, i % 2);
    Tube tube = make_tube(problem);
    TransferPlan plan;
    while (!tube.arrived() && collapse_shift_expand(tube, plan)) {
      const Problems found = check_transfer_plan(problem, plan);
      EXPECT_EQ(found.empty() ? "not-arrived" : found.front().code, "not-arrived");
    }
  }
}

TEST(CollapseShiftExpand, AnOrderThatItCannotGiveIsLeftAlone) {
  // The last loop of the front goes round the end onto the back's first, which must lie on it, but
  // loops that go round an end come last.
  const TransferProblem problem =
      moving({{Bed::front, 0}, {Bed::front, 1}, {Bed::back, 1}, {Bed::back, 0}},
             {{Bed::front, 0}, {Bed::back, 1}, {Bed::back, 1}, {Bed::back, 0}});
  ASSERT_TRUE(check_transfer_form(problem).empty());
  Tube tube = make_tube(problem);
  TransferPlan plan;
  while (!tube.arrived() && collapse_shift_expand(tube, plan)) {
  }
  EXPECT_FALSE(tube.arrived());
}

// What the primer measured of the published planner (section 4.1), on tubes of 12 to 48 loops. A
// yardstick that needs more passes than it would flatter our plans.
TEST(CollapseShiftExpand, TakesThePassesOfThePublishedPlanner) {
  for (const int width : {6, 12, 24}) {
    const std::vector<int> still = zeros(width), gap = step(width / 2, width / 2, 1),
                           decrease = step(width / 2, width / 2, -1);
    const auto passes = [](const TransferProblem& problem) {
      return count_slider_passes(whole_plan(problem));
    };
    EXPECT_EQ(passes(rolled(width, 0, 1)), 4) << width;
    EXPECT_EQ(passes(rolled(width, 0, 6)), 8) << width;   // the primer: 8-12
    EXPECT_EQ(passes(rolled(width, 1, 0)), 10) << width;  // 10-11
    EXPECT_GE(passes(rolled(width, 2, 0)), 12) << width;  // 12-20
    EXPECT_LE(passes(rolled(width, 2, 0)), 20) << width;
    EXPECT_EQ(passes(offsets(decrease, decrease)), 6) << width;
    EXPECT_EQ(passes(offsets(gap, still)), 5) << width;  // 5-6
    EXPECT_EQ(passes(offsets(gap, gap)), 6) << width;
  }
}

}  // namespace
}  // namespace meshknit
