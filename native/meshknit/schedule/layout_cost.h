#pragma once

#include <vector>

#include "meshknit/schedule/bed_layout.h"
#include "meshknit/schedule/slot_map.h"

namespace meshknit {

/// Stacks that change beds when the stacks of `before` go to their slots in `after`. Places do
/// not matter.
/// Requires: before.slots == map.stacks(), after.slots == map.slots().
int count_rolls(const SlotMap& map, const BedLayout& before, const BedLayout& after);

/// What one move costs, compared lexicographically.
struct MoveCost {
  long passes = 0;  ///< of the carriage, about (see MoveMeter)
  long shift = 0;   ///< stacks whose place changes
  long travel = 0;  ///< places, summed over stacks
  int offset = 0;   ///< place of the layout after minus place of the one before
};
bool operator<(const MoveCost& a, const MoveCost& b);
MoveCost operator+(const MoveCost& a, const MoveCost& b);

/// Offsets that may be chosen, and which is liked best among equally good ones.
struct OffsetChoice {
  int lowest = -1000000, highest = 1000000, liked = 0;
};

/// Finds the offset of least cost between two layouts. Works in time proportional to the shaping
/// of the step and the number of rolls. Keeps its scratch space between calls.
///
/// Passes are counted as the shortest plans make them (transfer/plan_transfers.h), nearly all of
/// which take:
///  - where stacks are shifted, one to lift them off their bed, and one for every way by which
///    stacks of the front bed, and of the back bed, are shifted;
///  - one for every way by which stacks roll from the front bed, and from the back bed; two more if
///    nothing is shifted and one of them rolls so far sideways that tubes beside it may not bear
///    the racking;
///  - one more if a decrease wants its lower stack to come to the upper one, which must be lifted
///    meanwhile (two if nothing else is lifted);
///  - two for every place beyond the second, which one racking does not reach.
class MoveMeter {
 public:
  MoveCost measure(const SlotMap& map, const BedLayout& before, const BedLayout& after,
                   const OffsetChoice& choice = {});

 private:
  // Stacks that go the same way; `way` is an offset between places.
  struct Moved {
    Bed from, to;
    int way, stacks;
  };
  void add(const Moved& moved);
  void collect(const SlotMap& map, const BedLayout& before, const BedLayout& after);
  void see_decrease(const SlotMap& map, const BedLayout& before, const BedLayout& after,
                    int second);
  MoveCost cost_of(int offset) const;

  std::vector<Moved> moved_;
  std::vector<int> upper_ways_;  // of the upper stacks of decreases that stay on their bed
};

}  // namespace meshknit
