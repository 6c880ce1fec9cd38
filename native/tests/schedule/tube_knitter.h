#pragma once

#include <cstddef>
#include <cstdint>
#include <vector>

#include "meshknit/schedule/schedule.h"
#include "meshknit/tracing/stitch.h"

namespace meshknit {

/// Knits one tube by hand and writes down its trace. The yarn sits at a stack; every call works
/// the next stack in the current direction.
class TubeKnitter {
 public:
  /// Starts `loops` loops anticlockwise.
  explicit TubeKnitter(int loops);

  TubeKnitter& knit(int stitches = 1);
  TubeKnitter& increase();
  TubeKnitter& decrease();
  /// Knits once over every stack.
  TubeKnitter& round();
  /// Tucks on the next stack and turns.
  TubeKnitter& turn();
  /// Knits the last round: no stitch has children.
  StitchTrace end();

  /// Loops that the next stacks hold together, in the current direction.
  size_t height_ahead(int stacks) const;

  int loops() const { return static_cast<int>(ring_.size()); }

 private:
  int ahead() const;
  int add(StitchKind kind);
  void give_parents(int stitch, const LoopStack& stack);

  StitchTrace trace_;
  std::vector<LoopStack> ring_;  // anticlockwise
  int at_ = 0;                   // stack that the yarn comes from
  Direction direction_ = Direction::anticlockwise;
};

/// A tube with random increases, decreases and short rows; shaping goes with probability about
/// 1/rarity a stitch.
StitchTrace knit_random_tube(std::uint32_t seed, int loops, int rounds, int rarity);

/// A tube that loses a loop a round, always at the same side, from `loops` down to `least`.
StitchTrace knit_one_sided_cone(int loops, int least);

/// `rounds` plain rounds over `loops` loops, start and end rounds included.
StitchTrace knit_plain_tube(int loops, int rounds);

}  // namespace meshknit
