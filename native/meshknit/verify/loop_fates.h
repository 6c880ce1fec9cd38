#pragma once

#include <vector>

#include "meshknit/tracing/stitch.h"
#include "meshknit/verify/expected_loops.h"
#include "meshknit/verify/fabric.h"
#include "meshknit/verify/problem_log.h"

namespace meshknit {

/// How the object's loops may end (primer, section 7, step 4): all are knit through by the
/// object, but those of end stitches, which are knit through by waste or dropped after their
/// yarn went out. Waste and anchors may be dropped, but waste that the object
/// hangs on only after the waste's yarn went out. `items` gives the traced loop of every loop.
void check_loop_fates(const Fabric& fabric, const StitchTrace& trace,
                      const std::vector<ExpectedLoop>& items, ProblemLog& log);

}  // namespace meshknit
