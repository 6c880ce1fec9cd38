#include "meshknit/emit/plan_moves.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <utility>

#include "emit/knitted_program.h"
#include "meshknit/core/error.h"
#include "meshknit/emit/step_transfers.h"
#include "meshknit/pipeline/pipeline.h"
#include "schedule/tube_knitter.h"
#include "shapes.h"

namespace meshknit {
namespace {

std::vector<std::pair<Place, Place>> ways(const TransferPlan& plan) {
  std::vector<std::pair<Place, Place>> result;
  for (const Transfer& transfer : plan.transfers)
    result.push_back({transfer.from, transfer.to});
  return result;
}

TEST(PlanMoves, WhoPlansAMoveDoesNotMatter) {
  const TimedShape piece = timed(opened(example_shape("cone")));
  const StitchTrace trace =
      build_trace(build_knit_graph(piece.surface, piece.time, {}).graph, shima());
  const Schedule schedule = build_schedule(trace, shima());
  const std::vector<TransferPlan> plans = plan_moves(trace, schedule, shima());
  ASSERT_EQ(plans.size(), schedule.steps.size());
  int moves = 0;
  for (std::size_t i = 0; i < plans.size(); ++i) {
    // A planner that knows of no other move.
    TransferPlanner planner;
    const ScheduleStep& step = schedule.steps[i];
    const TransferPlan alone =
        plan_step_transfers(step, transfer_direction(trace, step), shima(), planner);
    EXPECT_TRUE(ways(plans[i]) == ways(alone)) << "step " << i;
    moves += alone.transfers.empty() ? 0 : 1;
  }
  EXPECT_GT(moves, 10) << "a cone is shaped in many rows";
}

// Steps that nothing can move, one after another: planned at the same time, told of in order.
TEST(PlanMoves, OfSeveralImpossibleMovesTheFirstIsNamed) {
  const StitchTrace trace = knit_plain_tube(8, 6);
  Schedule schedule = schedule_stitches(trace, shima());
  ASSERT_GE(schedule.steps.size(), 5u);
  for (std::size_t i = 2; i < 5; ++i)
    for (Hook& hook : schedule.steps[i].moved_hooks)
      hook.n += hook.bed == Bed::front ? 30 : -30;
  MachineProfile stiff = shima();
  stiff.max_racking = 0;
  for (int round = 0; round < 20; ++round) {
    try {
      plan_moves(trace, schedule, stiff);
      FAIL() << "a machine that does not rack moves nothing sideways";
    } catch (const NotKnittable& refused) {
      const std::vector<int>& named = refused.problems().front().elements.stitches;
      for (const auto& loops : schedule.steps[2].before)
        EXPECT_EQ(std::count(named.begin(), named.end(), loops.front().stitch), 1);
    }
  }
}

}  // namespace
}  // namespace meshknit
