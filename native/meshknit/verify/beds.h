#pragma once

#include <cstddef>
#include <vector>

#include "meshknit/machine/machine_profile.h"
#include "meshknit/machine/program.h"

namespace meshknit {

/// What hangs on one needle or slider.
struct NeedleStack {
  std::vector<int> loops;  ///< earliest arrival first
  int column = -1;  ///< column of the tube that it belongs to; -1: anchors only, or empty
};

/// Both beds with hooks and sliders. The needles are those of the machine after the Position
/// header is applied: with "Keep" 1 to N; otherwise the pattern is moved, so any N in a row
/// from the lowest used.
class Beds {
 public:
  Beds(const Program& program, const MachineProfile& profile);

  bool has(const Needle& needle) const {
    return needle.index >= lowest_ && needle.index < lowest_ + width_;
  }
  int lowest() const { return lowest_; }
  int highest() const { return lowest_ + width_ - 1; }

  /// Requires: has(needle).
  NeedleStack& at(const Needle& needle) { return stacks_[index(needle)]; }
  const NeedleStack& at(const Needle& needle) const { return stacks_[index(needle)]; }

 private:
  std::size_t index(const Needle& needle) const;

  int lowest_ = 1;
  int width_ = 0;
  std::vector<NeedleStack> stacks_;
};

}  // namespace meshknit
