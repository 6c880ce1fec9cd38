#include "meshknit/schedule/layout_cost.h"

#include <algorithm>
#include <cstdlib>
#include <tuple>

namespace meshknit {
namespace {

constexpr int kReach = 2;  // places that one racking of a transfer reaches

int overlap(int begin_a, int end_a, int begin_b, int end_b) {
  return std::max(0, std::min(end_a, end_b) - std::max(begin_a, begin_b));
}

// The place of a slot when the front bed's left end is at place 0.
int place_of_turn(const BedLayout& layout, int turn) {
  return turn < layout.shape.front ? turn : layout.shape.left + layout.slots - 1 - turn;
}

int turns_from_first(const BedLayout& layout, int slot) {
  const int turn = (slot - layout.first) % layout.slots;
  return turn < 0 ? turn + layout.slots : turn;
}

}  // namespace

int count_rolls(const SlotMap& map, const BedLayout& before, const BedLayout& after) {
  const int n = map.stacks();
  const int begin = before.first, end = before.first + before.shape.front;
  const int new_begin = map.first_stack(after.first);
  const int new_end = map.first_stack(after.first + after.shape.front);
  int kept_on_front = 0;
  for (int turn = -2; turn <= 2; ++turn)
    kept_on_front += overlap(begin, end, new_begin + turn * n, new_end + turn * n);
  return (end - begin) + (new_end - new_begin) - 2 * kept_on_front;
}

bool operator<(const ShiftCost& a, const ShiftCost& b) {
  return std::tie(a.beyond, a.shift, a.travel) < std::tie(b.beyond, b.shift, b.travel);
}

ShiftCost operator+(const ShiftCost& a, const ShiftCost& b) {
  return {a.beyond + b.beyond, a.shift + b.shift, a.travel + b.travel, a.offset + b.offset};
}

void ShiftMeter::add(int by, int stacks) {
  for (Moved& moved : moved_)
    if (moved.by == by) {
      moved.stacks += stacks;
      return;
    }
  moved_.push_back({by, stacks});
}

// Stacks of one run that stay on their bed all move alike; only those that change beds are
// looked at one by one.
void ShiftMeter::collect(const SlotMap& map, const BedLayout& before, const BedLayout& after) {
  moved_.clear();
  const int n = map.stacks(), front_end = before.first + before.shape.front;
  for (int stack = before.first; stack < before.first + n;) {
    const int slot = map.slot_of(stack);
    const int turn = turns_from_first(after, slot);
    const bool was_front = stack < front_end, is_front = turn < after.shape.front;
    const int bed_end = slot - turn + (is_front ? after.shape.front : after.slots);
    int end = std::min(map.run_end(stack), map.first_stack(bed_end));
    end = std::min(end, was_front ? front_end : before.first + n);
    if (was_front == is_front) {
      add(place_of_turn(after, turn) - place_of_turn(before, stack - before.first),
          end - stack);
    } else {
      for (int i = 0; i < end - stack; ++i)
        add(place_of_turn(after, turn + i) - place_of_turn(before, stack - before.first + i),
            1);
    }
    stack = end;
  }
}

ShiftCost ShiftMeter::cost_of(int offset) const {
  ShiftCost cost;
  cost.offset = offset;
  for (const Moved& moved : moved_) {
    const int places = std::abs(moved.by + offset);
    cost.beyond += static_cast<long>(std::max(0, places - kReach)) * moved.stacks;
    cost.shift += places > 0 ? moved.stacks : 0;
    cost.travel += static_cast<long>(places) * moved.stacks;
  }
  return cost;
}

ShiftCost ShiftMeter::measure(const SlotMap& map, const BedLayout& before,
                              const BedLayout& after, const OffsetChoice& choice) {
  collect(map, before, after);
  int least = moved_.front().by, most = least;
  for (const Moved& moved : moved_) {
    least = std::min(least, moved.by);
    most = std::max(most, moved.by);
  }
  const int begin = std::clamp(-most, choice.lowest, choice.highest);
  const int end = std::clamp(-least, choice.lowest, choice.highest);
  ShiftCost best = cost_of(begin);
  for (int offset = begin + 1; offset <= end; ++offset) {
    const ShiftCost cost = cost_of(offset);
    const bool equal = !(cost < best) && !(best < cost);
    if (cost < best ||
        (equal && std::abs(offset - choice.liked) < std::abs(best.offset - choice.liked)))
      best = cost;
  }
  return best;
}

}  // namespace meshknit
