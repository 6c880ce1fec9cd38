#pragma once

#include <vector>

#include "meshknit/transfer/transfer_problem.h"

namespace meshknit {

/// A stack of loops of the tube, ready for planning. Sides count round the tube without end:
/// even sides are the front bed, odd ones the back, and side s+1 follows side s anticlockwise
/// (round the right end from the front, round the left end from the back). A loop that must go
/// round an end has goal_side != side.
struct Stack {
  int side = 0, place = 0;
  int goal_side = 0, goal = 0;
  int slack = 0;  ///< real needles to the next stack

  /// Passes round an end that are still to come, + anticlockwise (the primer's roll).
  int roll() const { return goal_side - side; }
};

inline Bed bed_of_side(int side) { return side % 2 == 0 ? Bed::front : Bed::back; }

/// The tube that a layout forms: stacks in anticlockwise order, sides never falling; the first
/// stack follows the last one on a side that is two higher.
struct Tube {
  std::vector<Stack> stacks;
  int lowest = 0, highest = 0;  ///< places that may be used
  int max_racking = 0;
  int left_end = 0, right_end = 0;  ///< outermost places before and after the transfers

  int next(int i) const { return i + 1 == static_cast<int>(stacks.size()) ? 0 : i + 1; }
  bool arrived() const;
};

/// Requires: check_transfer_form(problem) finds nothing.
/// Ensures: the sum of |roll| is as small as whole turns of the tube can make it.
Tube make_tube(const TransferProblem& problem);

/// Neighbouring stacks on one hook become one, for planning onwards from an intermediate
/// layout.
void merge_stacks(Tube& tube);

/// Neighbours that are planned as one because they have the same way to go.
struct Block {
  int first = 0, last = 0;  ///< stacks, inclusive
  int size() const { return last - first + 1; }
};

/// Cuts a tube into blocks. A run with one offset gives up to three: its two ends may be needed
/// at other moments than its middle, because they hang on to neighbours with other offsets.
/// Stacks that go round an end stand alone.
std::vector<Block> cut_into_blocks(const Tube& tube);

}  // namespace meshknit
