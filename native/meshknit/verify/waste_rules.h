#pragma once

#include <vector>

#include "meshknit/machine/machine_profile.h"
#include "meshknit/tracing/stitch.h"
#include "meshknit/verify/expected_loops.h"
#include "meshknit/verify/fabric.h"
#include "meshknit/verify/problem_log.h"

namespace meshknit {

/// What a machine wants to have knit before the object (primer, section 3): waste that reaches the
/// rollers (profile.take_down_rounds) and a draw thread that parts it from the object
/// (profile.draw_carrier). A warning where a tube starts narrower than the rollers can hold
/// (profile.take_down_width). `items` gives the traced loop of every loop.
void check_waste_below(const Fabric& fabric, const StitchTrace& trace,
                       const std::vector<ExpectedLoop>& items, const MachineProfile& profile,
                       ProblemLog& log);

}  // namespace meshknit
