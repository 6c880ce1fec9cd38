#pragma once

#include <vector>

#include "meshknit/core/run_context.h"
#include "meshknit/schedule/bed_layout.h"
#include "meshknit/schedule/slot_map.h"

namespace meshknit {

/// The best layouts of a tube (paper, section 3.4): `maps[i]` leads from layout i to layout
/// i+1, and the first layout has `maps[0].stacks()` slots. Minimises, summed over all and
/// compared lexicographically: alignment, rolls, places beyond reach, shifts, travel. Exact:
/// the result is one of the best, the one with the lowest first slot among equals.
///
/// The order is searched one part at a time. Alignment is least exactly if every even cycle is
/// aligned, since every layout can follow every other. Rolls depend only on which slots are on
/// which bed; shifts are weighed only along ways of fewest rolls. Places are relative: the
/// offset of each move is free. Requires: maps[i].slots() == maps[i+1].stacks() >= 2; `slots`
/// is the size of the first layout. Throws: Cancelled. Ensures: places of the result are 0.
std::vector<BedLayout> search_layouts(int slots, const std::vector<SlotMap>& maps,
                                      RunContext* run = nullptr);

}  // namespace meshknit
