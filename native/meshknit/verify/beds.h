#pragma once

#include <cstddef>
#include <vector>

#include "meshknit/machine/machine_profile.h"
#include "meshknit/machine/program.h"

namespace meshknit {

/// The needles of the machine after the Position header is applied: with "Keep" 1 to N; otherwise
/// the pattern is moved, so any N in a row from the lowest used.
class BedRange {
 public:
  BedRange(const Program& program, const MachineProfile& profile);

  bool has(const Needle& needle) const {
    return needle.index >= lowest_ && needle.index < lowest_ + width_;
  }
  int lowest() const { return lowest_; }
  int highest() const { return lowest_ + width_ - 1; }

  /// Hooks and sliders of both beds.
  std::size_t places() const { return static_cast<std::size_t>(width_) * 4; }
  /// Requires: has(needle).
  std::size_t place(const Needle& needle) const {
    const int row = (needle.bed == Bed::front ? 0 : 2) + (needle.slider ? 1 : 0);
    return static_cast<std::size_t>(row * width_ + needle.index - lowest_);
  }

 private:
  int lowest_ = 1;
  int width_ = 0;
};

/// What hangs on each hook and slider of both beds.
template <class Held>
class Beds : public BedRange {
 public:
  Beds(const Program& program, const MachineProfile& profile, const Held& empty)
      : BedRange(program, profile), held_(places(), empty) {}

  /// Requires: has(needle).
  Held& at(const Needle& needle) { return held_[place(needle)]; }
  const Held& at(const Needle& needle) const { return held_[place(needle)]; }

 private:
  std::vector<Held> held_;
};

}  // namespace meshknit
