#pragma once

#include <vector>

#include "meshknit/core/run_context.h"
#include "meshknit/machine/machine_profile.h"
#include "meshknit/machine/program.h"
#include "meshknit/tracing/stitch.h"
#include "meshknit/verify/expected_loops.h"
#include "meshknit/verify/fabric.h"
#include "meshknit/verify/problem_log.h"

namespace meshknit {

/// Follows the tubes through a replayed program (primer, section 7, steps 6 to 8). The trace says
/// which loops make a tube and where tubes part and meet (verify/trace_columns.h); waste belongs to
/// the tube that stands on it. Checked are
///  - the order of every tube's loops: always that none passes another of its tube, and that a tube
///    lies flat in its order while a stitch of it is made (so a loop is also knit on the side of
///    the fabric on which it was made, unless it was rolled round an end);
///  - that tubes stay clear of each other (verify/tubes.h) and keep their places left to right;
///  - that no yarn runs through a tube that it does not belong to;
///  - that second loops of increases and starts are made beside the loop before them.
/// A tube may part or meet from the last stitch across the place on, and must have by the stitch
/// that needs it; in between either will do.
/// `items` gives the traced loop of every loop of the fabric (compare_with_trace); it is empty where
/// there is no trace to go by. Then every loop belongs to the tube that its yarn comes from.
/// Reports the second half of the run. Throws: Cancelled.
void check_tubes(const Program& program, const MachineProfile& profile, const Fabric& fabric,
                 const StitchTrace& trace, const std::vector<ExpectedLoop>& items,
                 ProblemLog& log, RunContext* run = nullptr);

}  // namespace meshknit
