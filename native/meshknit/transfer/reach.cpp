#include "meshknit/transfer/reach.h"

#include <algorithm>
#include <cstdlib>

namespace meshknit {
namespace {

constexpr int middle = 32;

std::uint64_t bit(int offset) {
  const int at = middle + offset;
  return at < 0 || at > 63 ? 0 : std::uint64_t{1} << at;
}

std::uint64_t shifted(std::uint64_t set, int by) { return by >= 0 ? set << by : set >> -by; }

// All offsets within this distance of `offset`, as far as the set reaches.
std::uint64_t around(int offset, int distance) {
  const int low = std::max(0, middle + offset - distance);
  const int high = std::min(63, middle + offset + distance);
  return low > high ? 0 : (~std::uint64_t{0} >> (63 - (high - low))) << low;
}

}  // namespace

Reach::Reach(const Stack& stack)
    : first_side_(stack.side),
      direction_(stack.roll() < 0 ? -1 : 1),
      last_(std::min(std::abs(stack.roll()), most_sides - 1)),
      goal_offset_(stack.goal - stack.place) {
  sides_[0].hooks = bit(0);
}

void Reach::pass(const Pass& pass) {
  const int shift = shift_of(pass);
  // Backwards, so that a stack does not go round two ends in one pass.
  for (int j = last_; j >= 0; --j) {
    Side& side = sides_[j];
    const bool own_bed = bed_of_side(first_side_ + direction_ * j) == pass.from;
    if (!changes_side(pass)) {
      if (own_bed)
        side.parked |= shifted(side.hooks, shift);
      else
        side.hooks |= shifted(side.parked, shift);
    } else if (own_bed && j < last_) {
      sides_[j + 1].hooks |= shifted(side.hooks, shift);
    }
  }
}

bool Reach::home() const { return (sides_[last_].hooks & bit(goal_offset_)) != 0; }

bool Reach::may_come_home(int passes, int max_racking) const {
  if (home()) return true;
  const std::uint64_t near = around(goal_offset_, passes * ((max_racking + 1) / 2));
  for (int j = 0; j <= last_; ++j) {
    const int rolls = last_ - j;
    if (passes >= rolls + 1 && (sides_[j].parked & near) != 0) return true;
    // On its own side but away from home a stack must leave and come back.
    if (passes >= (rolls > 0 ? rolls : 2) && (sides_[j].hooks & near) != 0) return true;
  }
  return false;
}

std::vector<int> Reach::key(const Stack& stack) {
  return {((stack.side % 2) + 2) % 2, stack.roll(), stack.goal - stack.place};
}

}  // namespace meshknit
