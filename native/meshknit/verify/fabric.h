#pragma once

#include <string>
#include <vector>

#include "meshknit/machine/program.h"

namespace meshknit {

/// Lengths of yarn and rackings are counted in quarter needles: rackings come in quarters.
constexpr int kQuarters = 4;

/// One loop that the replayed program made.
struct Loop {
  enum class Fate { held, knit_through, dropped };

  int yarn = -1;
  int previous = -1, following = -1;  ///< neighbours on the yarn
  int line = 0;
  Op made_by = Op::knit;  ///< knit, tuck or split
  Side direction = Side::right;
  Needle made_on;
  Needle hangs_on;  ///< now, or last
  Source source;
  int first_parent = 0,
      parents = 0;  ///< range in Fabric::parents, lowest loop of the stack first
  int below = 0;    ///< a tuck: loops that the needle held already
  int child = -1;   ///< the loop that was (first) pulled through it
  Fate fate = Fate::held;
  int fate_line = 0;
  int made_distance = 0;  ///< quarter needles to the previous loop when this one was made
};

/// A carrier's yarn from its coming in to its going out.
struct Yarn {
  std::string carrier;
  int line_in = 0, line_out = 0;  ///< line_out 0: never went out
  std::vector<int> loops;
};

/// Everything that a program made, in the order of making.
struct Fabric {
  std::vector<Loop> loops;
  std::vector<int> parents;
  std::vector<Yarn> yarns;
  int max_stack = 0;
  int max_stretch = 0;  ///< quarter needles between yarn neighbours that were both held
};

/// True for loops of the object: all that is not declared waste or anchor.
inline bool is_object(const Loop& loop) {
  return loop.source.kind != Source::Kind::waste && loop.source.kind != Source::Kind::anchor;
}

/// Stitch number that the comment names, -1 if none; for reports only.
inline int named_stitch(const Loop& loop) {
  return loop.source.kind == Source::Kind::stitch ? loop.source.stitch : -1;
}

/// The way round the tube of a carriage direction: leftward is clockwise on the front bed and
/// anticlockwise on the back (contract, section 4).
inline bool is_clockwise(Bed bed, Side side) {
  return (bed == Bed::front) == (side == Side::left);
}

}  // namespace meshknit
