#include "meshknit/emit/plan_moves.h"

#include <algorithm>
#include <string>

#include "meshknit/core/error.h"
#include "meshknit/core/parallel.h"
#include "meshknit/emit/step_transfers.h"

namespace meshknit {
namespace {

[[noreturn]] void refuse_transfers(const StitchTrace& trace, const ScheduleStep& step) {
  Problem problem;
  problem.code = "transfer-impossible";
  problem.message = "The loops cannot be moved to where the row that begins with stitch " +
                    std::to_string(step.first_stitch) + " needs them.";
  problem.remedy = "Make the width of the object change more slowly there.";
  for (size_t i = 0; i < step.before.size(); ++i) {
    if (step.before_hooks[i] == step.moved_hooks[i]) continue;
    for (const LoopName& loop : step.before[i]) {
      if (loop.stitch < 0) continue;  // waste
      problem.elements.stitches.push_back(loop.stitch);
      problem.elements.nodes.push_back(trace.stitches[loop.stitch].node);
    }
  }
  std::vector<int>& nodes = problem.elements.nodes;
  std::sort(nodes.begin(), nodes.end());
  nodes.erase(std::unique(nodes.begin(), nodes.end()), nodes.end());
  throw NotKnittable({problem});
}

}  // namespace

std::vector<TransferPlan> plan_moves(const StitchTrace& trace, const Schedule& schedule,
                                     const MachineProfile& profile, RunContext* run) {
  const std::vector<ScheduleStep>& steps = schedule.steps;
  const int count = static_cast<int>(steps.size());
  std::vector<TransferPlan> plans(steps.size());
  Team team(count);
  // A planner each: what one learns makes the next plan faster, never another.
  std::vector<TransferPlanner> planners(static_cast<std::size_t>(team.workers()));
  team.for_each(count, [&](int i, int worker) {
    if (worker == 0) report(run, static_cast<double>(i) / count);
    const ScheduleStep& step = steps[i];
    try {
      plans[i] =
          plan_step_transfers(step, transfer_direction(trace, step), profile, planners[worker]);
    } catch (const NotKnittable&) {
      refuse_transfers(trace, step);  // the planner knows loops by number, a modeler by node
    }
  });
  return plans;
}

}  // namespace meshknit
