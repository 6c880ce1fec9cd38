#pragma once

#include <vector>

#include "meshknit/tracing/stitch.h"

namespace meshknit {

/// How the stacks of a tube go to the slots of the next step: stack i, counted anticlockwise,
/// goes to slot `slot_of(i)`. Two neighbours with one slot are decreased, a slot that no stack
/// goes to waits for an increase. Indices are unwrapped: one more turn round the tube adds the
/// number of stacks (of slots).
class SlotMap {
 public:
  SlotMap() = default;
  /// `slot_of_stack` never falls, and rises by at most `slots` from first to last. `direction` is the
  /// step's.
  SlotMap(std::vector<int> slot_of_stack, int slots,
          Direction direction = Direction::anticlockwise);

  int stacks() const { return static_cast<int>(slot_.size()); }
  int slots() const { return slots_; }
  /// Of two decreased stacks the one that this direction meets first must lie below.
  Direction direction() const { return direction_; }
  /// True if every stack keeps its number: the step neither increases nor decreases.
  bool is_identity() const { return identity_; }

  int slot_of(int stack) const;
  /// The first stack that goes to `slot` or a later one.
  int first_stack(int slot) const;
  /// The end (exclusive) of the run of stacks from `stack` on that are as far apart after as
  /// before.
  int run_end(int stack) const;

 private:
  std::vector<int> slot_, first_, run_end_;
  int slots_ = 0;
  Direction direction_ = Direction::anticlockwise;
  bool identity_ = false;
};

}  // namespace meshknit
