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
///     back        7 6 5 4
///     front       0 1 2 3        8 slots, first = 0, front = 4, left = 0: aligned
///                 ^ place
///
/// The five shapes of a cycle of six slots:
///
///     back     o o o       o o o    o o o         o o      o o o o
///     front    o o o     o o o        o o o     o o o o      o o
///     left       0         1         -1           1         -1
///
/// and the four of one of five:
///
///     back     o o         o o      o o o      o o o
///     front    o o o     o o o      o o          o o
///     left       0         1          0         -1
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

/// Needles that the yarn from bed to bed spans at the ends of the tube, the longer of the two; a
/// racking adds to it. Half-gauge place n is one needle further right on the back bed: 1 where the
/// back bed ends flush with the front or one place further left, 3 where it ends further right.
int longest_bridge(const BedLayout& layout);

/// The same of a tube that hangs on these hooks, in any order; 1 if it hangs on one bed only.
int longest_bridge(const std::vector<Hook>& hooks);

/// The hook of a slot, 0 <= slot < layout.slots.
Hook slot_hook(const BedLayout& layout, int slot);

/// The outermost places that a layout uses on either bed.
struct PlaceRange {
  int lowest = 0, highest = 0;
};
PlaceRange places_of(const BedLayout& layout);

/// Places that stay free between two layouts side by side, on the bed with fewer of them; 0 if the
/// tubes touch, negative if they overlap:
///
///     back     a a b b b        back     a a . b b b
///     front    a a a b b        front    a a a . b b
///              0: touching               1
int places_between(const BedLayout& left, const BedLayout& right);

}  // namespace meshknit
