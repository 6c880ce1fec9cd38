#pragma once

#include "meshknit/machine/machine_profile.h"
#include "meshknit/schedule/bed_order.h"
#include "meshknit/schedule/tube_steps.h"

namespace meshknit {

/// Refuses what no order or layout can help.
/// Throws: NotKnittable "stack-too-high" naming the stitches and nodes where tucks and decreases
/// pile up more loops than a needle holds.
void refuse_tall_stacks(const StitchTrace& trace, const SteppedTubes& tubes,
                        const MachineProfile& profile);

/// Refuses tubes that do not fit side by side on the bed at some step.
/// Throws: NotKnittable "too-wide" naming the nodes of the widest moment, how wide each tube is, and
/// the largest scale that fits.
void refuse_too_wide(const StitchTrace& trace, const SteppedTubes& tubes, const BedOrder& order,
                     const MachineProfile& profile);

/// True if tubes fit side by side only in narrow layouts (layout_search.h): others are up to a
/// place wider, and need one more beside them.
bool is_tight(const SteppedTubes& tubes, const BedOrder& order, const MachineProfile& profile);

}  // namespace meshknit
