#pragma once

#include "meshknit/machine/machine_profile.h"
#include "meshknit/schedule/schedule.h"
#include "meshknit/tracing/stitch.h"
#include "meshknit/transfer/transfer_problem.h"

namespace meshknit {

/// The transfers before a step that is knit in `direction`; none if no stack moves. Stacks that
/// are decreased together arrive in the order in which the step's stitches meet them, so that
/// each stitch finds its first parent lowest. Rackings stay within profile.liked_racking if a plan
/// of such exists, else within max_racking.
/// Throws: NotKnittable "transfer-impossible".
TransferPlan plan_step_transfers(const ScheduleStep& step, Direction direction,
                                 const MachineProfile& profile);

}  // namespace meshknit
