#include <gtest/gtest.h>

#include "meshknit/transfer/collapse_shift_expand.h"
#include "meshknit/transfer/plan_transfers.h"
#include "transfer/exact_search.h"
#include "transfer/transfer_examples.h"

namespace meshknit {
namespace {

// Passes of collapse-shift-expand alone, -1 if it gets stuck.
int passes_step_by_step(const TransferProblem& problem) {
  Tube tube = make_tube(problem);
  TransferPlan plan;
  while (!tube.arrived()) {
    const std::optional<PassPlan> step = collapse_shift_expand(tube);
    if (!step) return -1;
    advance(tube, *step, plan);
  }
  return count_passes(plan);
}

TEST(TransferYardstick, SmallTubesTakeHardlyMorePassesThanAnyPlan) {
  Lcg lcg(2018);
  int ours = 0, exact = 0, steps = 0, stuck = 0, problems = 0;
  while (problems < 120) {
    const TransferProblem problem = random_problem(lcg, 3, 2, problems % 3 == 0 ? 1 : 0);
    if (problem.loops.size() > 6) continue;
    ++problems;
    const int planned = count_passes(plan_transfers(problem));
    const int fewest = fewest_passes(problem, std::min(planned, 5));
    const int stepped = passes_step_by_step(problem);
    ours += planned;
    exact += planned <= 5 ? fewest : planned;
    steps += std::max(0, stepped);
    stuck += stepped < 0;
  }
  RecordProperty("ours", ours);
  RecordProperty("exact", exact);
  RecordProperty("collapse_shift_expand", steps);
  EXPECT_LE(ours, exact * 1.05);
  EXPECT_LE(ours, steps);
  EXPECT_EQ(stuck, 0);
}

}  // namespace
}  // namespace meshknit
