#include "meshknit/emit/step_transfers.h"

#include <algorithm>

#include "meshknit/core/error.h"

namespace meshknit {
namespace {

// Needle x of a bed becomes needle -x. Since a back hook lies one needle right of its place,
// loops of the back side go to place -n - 1.
int mirrored(Bed side, int n) { return side == Bed::front ? -n : -n - 1; }

Place mirrored(const Place& place) {
  const Bed side = place.parked ? opposite(place.bed) : place.bed;
  return {place.bed, mirrored(side, place.n), place.parked};
}

// Seen in a mirror clockwise is anticlockwise: the planner, which stacks loops in anticlockwise
// order, then stacks them in clockwise order. Lengths and the size of rackings stay the same.
TransferProblem mirrored(const TransferProblem& problem) {
  TransferProblem image = problem;
  std::reverse(image.loops.begin(), image.loops.end());
  for (TransferLoop& loop : image.loops) {
    loop.from = mirrored(loop.from_bed, loop.from);
    loop.to = mirrored(loop.to_bed, loop.to);
  }
  // slack[i] is between loops i and i + 1: reversed, the last one stays between last and first.
  std::reverse(image.slack.begin(), image.slack.end() - 1);
  image.lowest = -problem.highest;
  image.highest = -problem.lowest - 1;
  return image;
}

// With the rackings that the machine likes, if there is a way.
TransferPlan plan_as_liked(const TransferProblem& problem, const MachineProfile& profile,
                           TransferPlanner& planner) {
  if (profile.liked_racking < problem.max_racking) {
    TransferProblem liked = problem;
    liked.max_racking = profile.liked_racking;
    try {
      return planner.plan(liked);
    } catch (const NotKnittable&) {
      // The wider rackings remain.
    }
  }
  return planner.plan(problem);
}

}  // namespace

Direction transfer_direction(const StitchTrace& trace, const ScheduleStep& step) {
  return step.last_stitch < step.first_stitch ? Direction::anticlockwise
                                              : trace.stitches[step.first_stitch].direction;
}

TransferProblem step_transfer_problem(const ScheduleStep& step, Direction direction,
                                      const MachineProfile& profile) {
  TransferProblem problem;
  bool moves = false;
  for (size_t i = 0; i < step.before.size(); ++i) {
    const Hook &from = step.before_hooks[i], &to = step.moved_hooks[i];
    problem.loops.push_back({from.bed, from.n, to.bed, to.n});
    moves = moves || !(from == to);
  }
  if (!moves) return {};
  problem.slack = usual_slack(problem.loops);
  problem.max_racking = std::min(profile.max_racking, profile.max_stretch - step.bridge_beside);
  problem.lowest = step.lowest_place;
  problem.highest = step.highest_place;
  return direction == Direction::anticlockwise ? problem : mirrored(problem);
}

TransferPlan plan_step_transfers(const ScheduleStep& step, Direction direction,
                                 const MachineProfile& profile, TransferPlanner& planner) {
  const TransferProblem problem = step_transfer_problem(step, direction, profile);
  if (problem.loops.empty()) return {};
  TransferPlan plan = plan_as_liked(problem, profile, planner);
  if (direction == Direction::clockwise)
    for (Transfer& transfer : plan.transfers)
      transfer = {mirrored(transfer.from), mirrored(transfer.to)};
  return plan;
}

}  // namespace meshknit
