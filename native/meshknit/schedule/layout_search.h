#pragma once

#include <vector>

#include "meshknit/core/run_context.h"
#include "meshknit/schedule/bed_layout.h"
#include "meshknit/schedule/slot_map.h"

namespace meshknit {

/// The best layouts of a tube (paper, section 3.4): `maps[i]` leads from layout i to layout
/// i+1, and the first layout has `slots` slots. Minimises, summed over the tube and compared
/// lexicographically: alignment, rolls, places beyond reach, shifts, travel (layout_cost.h).
/// Exact; equally good layouts are told apart by their numbers.
///
/// The order is searched one part at a time. Every layout can follow every other, so alignment
/// is least exactly if every even cycle is aligned. Rolls depend only on which slots are on
/// which bed; shifts are weighed only along ways of fewest rolls. The offset of each move is
/// free, and the places of the result are 0.
///
/// Requires: slots >= 2; maps[i].stacks() is the size of layout i, maps[i].slots() >= 2 that of
/// layout i+1.
/// Throws: Cancelled.
std::vector<BedLayout> search_layouts(int slots, const std::vector<SlotMap>& maps,
                                      RunContext* run = nullptr);

}  // namespace meshknit
