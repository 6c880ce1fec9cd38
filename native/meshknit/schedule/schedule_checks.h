#pragma once

#include "meshknit/core/problem.h"
#include "meshknit/schedule/schedule.h"

namespace meshknit {

/// Every step starts where the one before ended; layouts are among the allowed shapes; stitches
/// are made on the stacks of their parents; new loops land on hooks that are free; hooks lie on
/// the machine. Problems name stitches.
Problems check_schedule(const StitchTrace& trace, const Schedule& schedule,
                        const MachineProfile& profile);

}  // namespace meshknit
