#include "meshknit/schedule/slot_map.h"

#include <utility>

namespace meshknit {
namespace {

struct Turns {
  int whole, rest;
};

Turns unwrap(int index, int period) {
  int rest = index % period;
  if (rest < 0) rest += period;
  return {(index - rest) / period, rest};
}

}  // namespace

SlotMap::SlotMap(std::vector<int> slot_of_stack, int slots, Direction direction)
    : slot_(std::move(slot_of_stack)), slots_(slots), direction_(direction) {
  const int stacks_count = stacks();
  run_end_.resize(slot_.size());
  for (int i = stacks_count - 1; i >= 0; --i) {
    const bool last = i == stacks_count - 1;
    run_end_[i] = last || slot_[i + 1] != slot_[i] + 1 ? i + 1 : run_end_[i + 1];
  }
  first_.resize(slots_);
  // The lowest slot may be reached by a stack of the turn before.
  int stack = -stacks_count;
  for (int slot = 0; slot < slots_; ++slot) {
    while (slot_of(stack) < slot) ++stack;
    first_[slot] = stack;
  }
  identity_ = stacks_count == slots_;
  for (int i = 0; i < stacks_count && identity_; ++i) identity_ = slot_[i] == i;
}

int SlotMap::slot_of(int stack) const {
  const Turns at = unwrap(stack, stacks());
  return slot_[at.rest] + at.whole * slots_;
}

int SlotMap::first_stack(int slot) const {
  const Turns at = unwrap(slot, slots_);
  return first_[at.rest] + at.whole * stacks();
}

int SlotMap::run_end(int stack) const {
  const Turns at = unwrap(stack, stacks());
  return run_end_[at.rest] + at.whole * stacks();
}

}  // namespace meshknit
