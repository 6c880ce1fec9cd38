#pragma once

#include <optional>
#include <vector>

#include "meshknit/core/run_context.h"
#include "meshknit/schedule/bed_layout.h"
#include "meshknit/schedule/layout_cost.h"
#include "meshknit/schedule/slot_map.h"

namespace meshknit {

/// What else a tube's layouts must be.
struct LayoutLimits {
  std::optional<BedLayout> first, last;  ///< set where tubes part or meet; aligned if even
  /// The tube hangs beside others and must bear any racking that they are moved with: the ends of
  /// its back bed lie flush with the front's or one place further left. A yarn bridge between place
  /// n of the front and n or n - 1 of the back is then never stretched over more than |racking| + 1
  /// needles.
  bool beside_others = false;
};

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
/// layout i+1; at least one map if both ends are set.
/// Throws: Cancelled.
struct FoundLayouts {
  std::vector<BedLayout> layouts;
  long rolls = 0;
  ShiftCost moves;
};
FoundLayouts search_layouts(int slots, const std::vector<SlotMap>& maps,
                            const LayoutLimits& limits = {}, RunContext* run = nullptr);

}  // namespace meshknit
