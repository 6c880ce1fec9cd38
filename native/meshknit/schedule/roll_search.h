#pragma once

#include <algorithm>
#include <vector>

#include "meshknit/core/run_context.h"
#include "meshknit/schedule/bed_layout.h"
#include "meshknit/schedule/layout_cost.h"
#include "meshknit/schedule/slot_map.h"

namespace meshknit {

/// The ways to split a cycle between the beds: for each number of front slots that a shape has
/// (bed_layout.h; three for N even, two for N odd) and each first slot one split, numbered in that
/// order.
class BedSplits {
 public:
  explicit BedSplits(int slots);
  int slots() const { return slots_; }
  int fronts() const { return static_cast<int>(front_.size()); }
  int size() const { return fronts() * slots_; }
  int number(int front_index, int first) const { return front_index * slots_ + first; }
  /// The split of a layout.
  int number_of(const BedLayout& layout) const {
    const auto front = std::find(front_.begin(), front_.end(), layout.shape.front);
    return number(static_cast<int>(front - front_.begin()), layout.first);
  }
  /// The split as a layout, whatever its ends.
  BedLayout layout(int number) const {
    return {slots_, number % slots_, {front_[number / slots_], 0}, 0};
  }

 private:
  int slots_;
  std::vector<int> front_;
};

/// Calls visit(number, rolls) for every split of `after` that at most `most` rolls from
/// `before` lead to, in a fixed order.
template <typename Visit>
void for_each_split_within(const SlotMap& map, const BedLayout& before, const BedSplits& after,
                           int most, Visit visit) {
  // r rolls move the left end of the front bed by at most r, unless all of one bed goes.
  const int all = after.slots();
  const bool any = most >= std::min(before.shape.front, before.slots - before.shape.front);
  const int begin = any ? 0 : map.slot_of(before.first - most - 1) + 1;
  const int end = any ? all : std::min(map.slot_of(before.first + most) + 1, begin + all);
  for (int front = 0; front < after.fronts(); ++front)
    for (int slot = begin; slot < end; ++slot) {
      const int first = ((slot % all) + all) % all;
      const int number = after.number(front, first);
      const int rolls = count_rolls(map, before, after.layout(number));
      if (rolls <= most) visit(number, rolls);
    }
}

/// Fewest rolls from the start to every split of every cycle, and from there to the end.
struct RollTable {
  std::vector<std::vector<int>> from_start;  ///< [cycle][split]
  std::vector<std::vector<int>> to_end;      ///< [cycle][split]
  int fewest = 0;
};

/// Splits that the ends of the way must have; -1 for any.
struct SplitEnds {
  int first = -1, last = -1;
};

/// `maps[i]` leads from cycle i to cycle i+1. Works in time proportional to the stacks of all
/// cycles and their shaping.
/// Throws: Cancelled.
RollTable search_rolls(const std::vector<BedSplits>& splits, const std::vector<SlotMap>& maps,
                       const SplitEnds& ends, RunContext* run);

}  // namespace meshknit
