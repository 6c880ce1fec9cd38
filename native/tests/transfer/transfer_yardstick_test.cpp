#include <gtest/gtest.h>

#include <algorithm>

#include "meshknit/transfer/plan_transfers.h"
#include "meshknit/transfer/transfer_checks.h"
#include "transfer/exact_search.h"
#include "transfer/textbook_planner.h"
#include "transfer/transfer_examples.h"

namespace meshknit {
namespace {

// Problems of at most so many loops, every third with loops that change beds: passes of our plans,
// of the shortest there are, and of collapse-shift-expand alone.
struct Measured {
  int problems = 0, ours = 0, exact = 0, textbook = 0, stuck = 0;
};
Measured measure(int most_loops, int problems, int longest) {
  Lcg lcg(2018);
  TransferPlanner planner;
  Measured measured;
  while (measured.problems < problems) {
    const TransferProblem problem =
        random_problem(lcg, most_loops / 2, 2, measured.problems % 3 == 0 ? 1 : 0);
    if (static_cast<int>(problem.loops.size()) > most_loops) continue;
    const int planned = count_passes(planner.plan(problem));
    if (planned > longest) continue;  // the exact search would take too long
    const TextbookPlan textbook = collapse_shift_expand_alone(problem);
    ++measured.problems;
    if (!textbook.arrived) {
      ++measured.stuck;
      continue;
    }
    EXPECT_TRUE(check_transfer_plan(problem, textbook.plan).empty());
    measured.ours += planned;
    measured.exact += planned == 0 ? 0 : fewest_passes(problem, planned);
    measured.textbook += count_passes(textbook.plan);
  }
  return measured;
}

void expect_close_to_exact(const Measured& measured) {
  const auto mean = [&](int passes) {
    return std::to_string(1.0 * passes / (measured.problems - measured.stuck));
  };
  testing::Test::RecordProperty("mean_passes_ours", mean(measured.ours));
  testing::Test::RecordProperty("mean_passes_exact", mean(measured.exact));
  testing::Test::RecordProperty("mean_passes_textbook", mean(measured.textbook));
  // Where the search is complete nothing is shorter; it stops where a plan takes too long.
  EXPECT_LE(measured.ours, measured.exact * 1.02);
  EXPECT_LE(measured.ours, measured.textbook * 0.8);
  EXPECT_LE(measured.stuck, measured.problems / 50);
}

TEST(TransferYardstick, SixLoopsTakeHardlyMorePassesThanAnyPlan) {
  expect_close_to_exact(measure(6, 300, 6));
}

TEST(TransferYardstick, EightLoopsTakeHardlyMorePassesThanAnyPlan) {
  expect_close_to_exact(measure(8, 100, 5));
}

}  // namespace
}  // namespace meshknit
