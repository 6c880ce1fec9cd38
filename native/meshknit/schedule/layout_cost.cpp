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

// Place n of the back bed lies one needle right of place n of the front: a roll straight across, or
// one place against that, takes a racking of 1, others take 3 or more.
bool is_far_roll(Bed from, int way) { return way != 0 && way != (from == Bed::front ? -1 : 1); }

Bed bed_of_turn(const BedLayout& layout, int turn) {
  return turn < layout.shape.front ? Bed::front : Bed::back;
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

bool operator<(const MoveCost& a, const MoveCost& b) {
  return std::tie(a.passes, a.shift, a.travel) < std::tie(b.passes, b.shift, b.travel);
}

MoveCost operator+(const MoveCost& a, const MoveCost& b) {
  return {a.passes + b.passes, a.shift + b.shift, a.travel + b.travel, a.offset + b.offset};
}

void MoveMeter::add(const Moved& moved) {
  for (Moved& known : moved_)
    if (known.from == moved.from && known.to == moved.to && known.way == moved.way) {
      known.stacks += moved.stacks;
      return;
    }
  moved_.push_back(moved);
}

void MoveMeter::see_decrease(const SlotMap& map, const BedLayout& before,
                             const BedLayout& after, int second) {
  const int upper = map.direction() == Direction::anticlockwise ? second : second - 1;
  const int from = turns_from_first(before, upper);
  const int to = turns_from_first(after, map.slot_of(upper));
  if (bed_of_turn(before, from) == bed_of_turn(after, to))
    upper_ways_.push_back(place_of_turn(after, to) - place_of_turn(before, from));
}

// Stacks of one run that stay on their bed all move alike; only those that change beds are
// looked at one by one.
void MoveMeter::collect(const SlotMap& map, const BedLayout& before, const BedLayout& after) {
  moved_.clear();
  upper_ways_.clear();
  const int n = map.stacks(), front_end = before.first + before.shape.front;
  for (int stack = before.first; stack < before.first + n;) {
    const int slot = map.slot_of(stack);
    const int turn = turns_from_first(after, slot);
    const Bed from = stack < front_end ? Bed::front : Bed::back, to = bed_of_turn(after, turn);
    const int bed_end = slot - turn + (to == Bed::front ? after.shape.front : after.slots);
    int end = std::min(map.run_end(stack), map.first_stack(bed_end));
    end = std::min(end, from == Bed::front ? front_end : before.first + n);
    if (map.slot_of(stack - 1) == slot) see_decrease(map, before, after, stack);
    const int way = place_of_turn(after, turn) - place_of_turn(before, stack - before.first);
    if (from == to) {
      add({from, to, way, end - stack});
    } else {
      // Those that come after it go two places less, or more, each: the beds run opposite ways.
      const int turned = to == Bed::front ? 2 : -2;
      for (int i = 0; i < end - stack; ++i) add({from, to, way + i * turned, 1});
    }
    stack = end;
  }
}

MoveCost MoveMeter::cost_of(int offset) const {
  MoveCost cost;
  cost.offset = offset;
  bool lifted = false, far_roll = false;
  for (const Moved& moved : moved_) {
    const int places = std::abs(moved.way + offset);
    const bool rolls = moved.from != moved.to;
    cost.passes += (rolls || places > 0 ? 1 : 0) + 2 * std::max(0, places - kReach);
    lifted = lifted || (!rolls && places > 0);
    far_roll = far_roll || (rolls && is_far_roll(moved.from, moved.way + offset));
    cost.shift += places > 0 ? moved.stacks : 0;
    cost.travel += static_cast<long>(places) * moved.stacks;
  }
  cost.passes += lifted ? 1 : far_roll ? 2 : 0;
  if (std::count(upper_ways_.begin(), upper_ways_.end(), -offset) > 0)
    cost.passes += lifted ? 1 : 2;
  return cost;
}

MoveCost MoveMeter::measure(const SlotMap& map, const BedLayout& before, const BedLayout& after,
                            const OffsetChoice& choice) {
  collect(map, before, after);
  int least = moved_.front().way, most = least;
  for (const Moved& moved : moved_) {
    least = std::min(least, moved.way);
    most = std::max(most, moved.way);
  }
  const int begin = std::clamp(-most, choice.lowest, choice.highest);
  const int end = std::clamp(-least, choice.lowest, choice.highest);
  MoveCost best = cost_of(begin);
  for (int offset = begin + 1; offset <= end; ++offset) {
    const MoveCost cost = cost_of(offset);
    const bool equal = !(cost < best) && !(best < cost);
    if (cost < best ||
        (equal && std::abs(offset - choice.liked) < std::abs(best.offset - choice.liked)))
      best = cost;
  }
  return best;
}

}  // namespace meshknit
