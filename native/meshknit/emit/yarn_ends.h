#pragma once

#include <string>
#include <vector>

#include "meshknit/emit/program_builder.h"
#include "meshknit/machine/machine_profile.h"
#include "meshknit/schedule/bed_layout.h"

namespace meshknit {

/// Brings a carrier in and ties its yarn end with three anchor tucks (primer, sections 3
/// and 5.1), so that it can make a first stitch on `first`, travelling to `side`. The tucks lie
/// on the parked needles of the front bed, which are empty between transfers: beside the stitch, on
/// the side that the yarn comes from, as far as `room` allows, else nearer to it or beyond. The
/// first of them goes the way that the machine asks for, and nothing is worked beyond it before the
/// hook is released. Returns the anchored needles: to be dropped before any transfer.
/// Requires: `room` has three places or more, none further than three from `first` left out.
std::vector<Needle> bring_in(ProgramBuilder& program, const MachineProfile& profile,
                             const std::string& carrier, const Hook& first, Side side,
                             const PlaceRange& room);

/// Takes the carrier away.
void take_out(ProgramBuilder& program, const MachineProfile& profile,
              const std::string& carrier);

}  // namespace meshknit
