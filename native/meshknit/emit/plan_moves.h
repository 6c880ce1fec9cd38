#pragma once

#include <vector>

#include "meshknit/core/run_context.h"
#include "meshknit/machine/machine_profile.h"
#include "meshknit/schedule/schedule.h"
#include "meshknit/tracing/stitch.h"
#include "meshknit/transfer/transfer_problem.h"

namespace meshknit {

/// The transfers before every step of the schedule: one plan a step, empty where nothing moves. Moves
/// know nothing of each other, so they are planned on several threads (core/parallel.h); plans and
/// refusals are those of one thread.
/// Requires: check_schedule finds nothing.
/// Throws: NotKnittable "transfer-impossible" for the first step whose loops no plan moves (names the
/// stitches and nodes that would move); Cancelled.
std::vector<TransferPlan> plan_moves(const StitchTrace& trace, const Schedule& schedule,
                                     const MachineProfile& profile, RunContext* run = nullptr);

}  // namespace meshknit
