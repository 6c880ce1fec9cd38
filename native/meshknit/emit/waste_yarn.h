#pragma once

#include <vector>

#include "meshknit/emit/program_builder.h"
#include "meshknit/machine/machine_profile.h"
#include "meshknit/schedule/bed_layout.h"

namespace meshknit {

/// Casts a tube of waste on to the empty hooks of a layout (anticlockwise): every second loop
/// of a round, then the others, then the plain rounds that the profile asks for (primer,
/// sections 5.1 and 5.2), then, where the machine has a carrier for it, a round of draw thread. The
/// carriers come in and go out again; no anchor stays. Works in `room` only.
void knit_waste_before(ProgramBuilder& program, const MachineProfile& profile,
                       const std::vector<Hook>& hooks, const PlaceRange& room);

/// Knits profile.waste_rounds rounds of waste over the object's last loops, so that they cannot
/// unravel, and drops them. Works in `room` only.
void knit_waste_after(ProgramBuilder& program, const MachineProfile& profile,
                      const std::vector<Hook>& hooks, const PlaceRange& room);

}  // namespace meshknit
