#pragma once

#include <vector>

#include "meshknit/machine/machine_profile.h"
#include "meshknit/schedule/bed_layout.h"
#include "meshknit/schedule/slot_map.h"

namespace meshknit {

/// The half-gauge places that a tube's layouts may use: all of a bed's but a few at each end,
/// which transfers and yarn ends need.
PlaceRange usable_places(const MachineProfile& profile);

/// Gives every layout its place (search_layouts; maps[i] leads from layout i to i+1): each move
/// by the offset of least movement, equally good ones so that the tube stays in the middle of
/// the bed, the whole centred.
/// Requires: every layout fits into usable_places(profile).
/// Ensures: every layout lies in usable_places(profile). Returns true if no move had to be
/// worse than its best for that.
bool place_layouts(std::vector<BedLayout>& layouts, const std::vector<SlotMap>& maps,
                   const MachineProfile& profile);

}  // namespace meshknit
