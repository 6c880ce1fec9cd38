#pragma once

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
  int first_side_;
  int direction_;
  std::uint64_t goal_;
  int goal_offset_;
  std::vector<Side> sides_;  // from the first side to the goal side
};

}  // namespace meshknit
