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
  std::optional<BedLayout> first, last;  ///< set where tubes part or meet
  /// As narrow as can be: aligned if even, with a longest_bridge of 1 if odd.
  bool narrow = false;
};

/// The best layouts of a tube: `maps[i]` leads from layout i to layout i+1, and the first layout
/// has `slots` slots. Minimises the cost of moving (layout_cost.h), summed over the tube.
///
/// The paper (section 3.4) puts alignment first, then rolls, then shifts. What a machine spends is
/// passes: a stack that is rolled to align a tube again often waits on its side for the next
/// decrease, which brings it back. All layouts have ends that bear the rackings of other tubes
/// (bed_layout.h), so alignment is wanted only where tubes part or meet.
///
/// Exact among the ways of which every move lies on some way that rolls at most kMoreRolls stacks more
/// than needed, and rolls at most kRollsAtOnce more than if the rolls were spread evenly over all moves
/// (more only where no such way exists); equally good layouts are told apart by their numbers. The offset of each move
/// is free, and the places of the result are 0.
///
/// Requires: slots >= 2; maps[i].stacks() is the size of layout i, maps[i].slots() >= 2 that of
/// layout i+1; at least one map if both ends are set.
/// Throws: BrokenPromise if the limits leave no way; Cancelled.
struct FoundLayouts {
  std::vector<BedLayout> layouts;
  MoveCost cost;
};
FoundLayouts search_layouts(int slots, const std::vector<SlotMap>& maps,
                            const LayoutLimits& limits = {}, RunContext* run = nullptr);

constexpr int kMoreRolls = 2, kRollsAtOnce = 4;

/// The fewest rolls of any layouts of the tube: a quick measure of how far its ends are turned
/// against each other. Same requirements.
long fewest_rolls(int slots, const std::vector<SlotMap>& maps, const LayoutLimits& limits,
                  RunContext* run = nullptr);

}  // namespace meshknit
