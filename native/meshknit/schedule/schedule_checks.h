#pragma once

#include "meshknit/core/problem.h"
#include "meshknit/schedule/schedule.h"

namespace meshknit {

/// Every step starts where its tube was left, or takes over loops of waste or of other tubes where
/// they hang; layouts are among the allowed shapes; stitches are made on the stacks of their
/// parents; new loops land on hooks that are free; tubes that are knit have a free place beside
/// them, and no other tube hangs in the room of a step; the longest yarn between the beds beside a
/// step is what the step says; every tube that nothing takes over ends; hooks lie on the machine.
/// Problems name stitches.
/// Requires: check_trace finds nothing for the trace. Any schedule may be asked about.
Problems check_schedule(const StitchTrace& trace, const Schedule& schedule,
                        const MachineProfile& profile);

}  // namespace meshknit
