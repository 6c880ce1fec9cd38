#pragma once

#include "meshknit/core/run_context.h"
#include "meshknit/machine/machine_profile.h"
#include "meshknit/machine/program.h"
#include "meshknit/schedule/schedule.h"
#include "meshknit/tracing/stitch.h"

namespace meshknit {

/// Schedule -> machine program: for each tube that starts a waste tube with anchor tucks and alternating cast-on, the
/// object (transfers planned and replayed, stitches, increases by reverse tuck, short-row
/// tucks), and for each tube that ends waste and drop (knitout primer, section 5). Every yarn comes
/// in on a carrier of its own right before its first stitch and goes out right after its last. Every operation that makes a loop names its
/// source. Needle numbers are those of the machine ("Position: Keep").
///
/// An increase's second loop is tucked against the direction of its stitch round the tube;
/// where the stitch is the last on its bed, that is the stitch's own carriage direction.
/// Requires: check_schedule finds nothing.
/// Throws: NotKnittable "transfer-impossible" if some move between two layouts has no transfer
/// plan (names the stitches and nodes that would move); "too-many-carriers" (carriers.h); Cancelled.
Program emit_program(const StitchTrace& trace, const Schedule& schedule,
                     const MachineProfile& profile, RunContext* run = nullptr);

}  // namespace meshknit
