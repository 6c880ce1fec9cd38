#pragma once

#include <array>
#include <cstdint>
#include <vector>

#include "meshknit/transfer/pass.h"
#include "meshknit/transfer/tube.h"

namespace meshknit {

/// The places where a stack could be after some passes if it were alone on the machine,
/// relative to where it began: a quick test that most sequences of passes fail. Sets are bit
/// masks; bit 32 is the beginning.
class Reach {
 public:
  Reach() = default;
  explicit Reach(const Stack& stack);

  void pass(const Pass& pass);
  bool home() const;
  /// False if `passes` more passes of at most `max_racking` cannot bring the stack home.
  bool may_come_home(int passes, int max_racking) const;

  /// Stacks with equal keys reach alike.
  static std::vector<int> key(const Stack& stack);

 private:
  struct Side {
    std::uint64_t hooks = 0, parked = 0;
  };
  // Two layouts of one tube span at most three sides each, so after whole turns no stack has
  // more than five ends to go round.
  static constexpr int most_sides = 6;
  int first_side_ = 0, direction_ = 1, last_ = 0;
  int goal_offset_ = 0;
  std::array<Side, most_sides> sides_;  // from the first side to the goal side, 0..last_
};

}  // namespace meshknit
