#pragma once

#include <vector>

#include "meshknit/schedule/bed_layout.h"
#include "meshknit/schedule/slot_map.h"

namespace meshknit {

/// Stacks that change beds when the stacks of `before` go to their slots in `after`. Places do
/// not matter.
/// Requires: before.slots == map.stacks(), after.slots == map.slots().
int count_rolls(const SlotMap& map, const BedLayout& before, const BedLayout& after);

/// Sideways movement of the stacks that `offset` (place of `after` minus place of `before`)
/// causes, compared lexicographically. A move by more than two places needs more than one
/// racking, so it is avoided first.
struct ShiftCost {
  long beyond = 0;  ///< places beyond the second, summed over stacks
  long shift = 0;   ///< stacks whose place changes
  long travel = 0;  ///< places, summed over stacks
  int offset = 0;
};
bool operator<(const ShiftCost& a, const ShiftCost& b);
ShiftCost operator+(const ShiftCost& a, const ShiftCost& b);

/// Offsets that may be chosen, and which is liked best among equally good ones.
struct OffsetChoice {
  int lowest = -1000000, highest = 1000000, liked = 0;
};

/// Finds the offset of least movement between two layouts. Works in time proportional to the
/// shaping of the step and the number of rolls. Keeps its scratch space between calls.
class ShiftMeter {
 public:
  ShiftCost measure(const SlotMap& map, const BedLayout& before, const BedLayout& after,
                    const OffsetChoice& choice = {});

 private:
  struct Moved {
    int by, stacks;
  };
  void add(int by, int stacks);
  void collect(const SlotMap& map, const BedLayout& before, const BedLayout& after);
  ShiftCost cost_of(int offset) const;

  std::vector<Moved> moved_;
};

}  // namespace meshknit
