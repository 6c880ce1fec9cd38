#pragma once

#include <string_view>

#include "meshknit/core/problem.h"
#include "meshknit/machine/machine_profile.h"

namespace meshknit {

/// Whether a .kc file makes the loops of a knitout file: both are read and knit on the simulated
/// machine; then every loop must be made in the same order, on the same needle, in the same
/// direction, of the same carrier, through the same loops, and must end the same way. Also that
/// carriers start from where they stopped, on the side from which the pass comes, and that none waits
/// above needles at work. Never throws on any text.
/// Codes: "bad-kcode" (not of the form), "kcode-differs", "carrier-elsewhere", "carrier-in-the-way".
Problems check_kcode(std::string_view kcode, std::string_view knitout,
                     const MachineProfile& profile);

}  // namespace meshknit
