#pragma once

#include "meshknit/machine/machine_profile.h"
#include "meshknit/schedule/schedule.h"
#include "meshknit/tracing/stitch.h"
#include "meshknit/transfer/plan_transfers.h"

namespace meshknit {

/// The direction in which a step is knit. A tube that is only moved decreases nothing, so either
/// way will do.
Direction transfer_direction(const StitchTrace& trace, const ScheduleStep& step);

/// What must be moved before a step that is knit in `direction`; no loops if nothing must. For
/// clockwise steps it is seen in a mirror, so that the planner, which stacks loops in
/// anticlockwise order, stacks them in the order in which the step's stitches meet them.
TransferProblem step_transfer_problem(const ScheduleStep& step, Direction direction,
                                      const MachineProfile& profile);

/// The transfers before a step that is knit in `direction`; none if no stack moves. Stacks that
/// are decreased together arrive in the order in which the step's stitches meet them, so that
/// each stitch finds its first parent lowest. Rackings stay within profile.liked_racking if a plan
/// of such exists, else within max_racking.
/// Throws: NotKnittable "transfer-impossible".
TransferPlan plan_step_transfers(const ScheduleStep& step, Direction direction,
                                 const MachineProfile& profile, TransferPlanner& planner);

}  // namespace meshknit
