#pragma once

#include <vector>

#include "meshknit/machine/needle.h"
#include "meshknit/schedule/schedule.h"

namespace meshknit {

/// How a cycle of slots is split between the beds. Ends of the beds never differ by more than
/// one place.
struct BedShape {
  int front = 0;  ///< slots on the front bed
  int left = 0;   ///< left end of the back bed, seen from that of the front bed: -1, 0 or 1
};

/// Where a cycle of N slots hangs (paper, section 3.4 and Figure 16): one of 5N layouts for N
/// even, 4N for N odd, at a place. Slots count anticlockwise, seen from above the beds:
///
///     back        7 6 5 4        slots 0..7, first = 0, front = 4, left = 0: aligned
///     front       0 1 2 3
///                 ^ place
///
/// The five shapes of an even cycle (here 6 slots) and the four of an odd one (5 slots):
///
///     back     o o o      o o o    o o o          o        o o o o
///     front    o o o    o o o        o o o    o o o o o      o o         (the last two for 8
///     and 6 slots)
///
///     back     o o        o o    o o o      o o o
///     front    o o o    o o o    o o          o o
struct BedLayout {
  int slots = 0;
  int first = 0;  ///< the slot at the left end of the front bed: the rotation
  BedShape shape;
  int place = 0;  ///< half-gauge place of the left end of the front bed
};

/// All shapes of a cycle with a slot on each bed, aligned first. 5 for N even, 4 for N odd,
/// fewer for N < 4.
std::vector<BedShape> bed_shapes(int slots);

/// True if both beds reach equally far at both ends.
bool is_aligned(const BedLayout& layout);

/// The hook of a slot, 0 <= slot < layout.slots.
Hook slot_hook(const BedLayout& layout, int slot);

/// The outermost places that a layout uses on either bed.
struct PlaceRange {
  int lowest = 0, highest = 0;
};
PlaceRange places_of(const BedLayout& layout);

}  // namespace meshknit
