#pragma once

#include <optional>
#include <vector>

#include "meshknit/transfer/itinerary.h"
#include "meshknit/transfer/pass.h"
#include "meshknit/transfer/tube.h"

namespace meshknit {

/// Neighbouring stacks that go together because they have the same way to go (a Block), hooked or
/// parked.
struct HangingRun {
  Stack stack;              ///< the first; its slack is that of the last to the next run
  std::vector<int> beyond;  ///< places of the others, beside the first
  std::vector<int> slacks;  ///< between them
  bool parked = false;

  int size() const { return 1 + static_cast<int>(beyond.size()); }
  int reach() const { return beyond.empty() ? 0 : beyond.back(); }
  Stop stop() const { return {stack.side, stack.place, parked}; }
  void go_to(const Stop& stop) {
    stack.side = stop.side;
    stack.place = stop.place;
    parked = stop.parked;
  }
};

/// A tube on its way through collapse-shift-expand.
struct CollapsingTube {
  Tube tube;                        ///< limits and ends; its stacks are not used
  std::vector<HangingRun> hanging;  ///< anticlockwise, those of the bed that is collapsed first
  int top = 0;                      ///< how many runs hang on hooks of the bed that is collapsed
  TransferPlan plan;                ///< so far
  std::optional<Pass> pass;         ///< the last one of the plan

  int count() const { return static_cast<int>(hanging.size()); }
};

/// The way that still lies before a stack of this tube, in places, and 2 for every end that it
/// must go round (knitout primer, 4.1).
long remaining_way(const Tube& tube, const Stack& stack, const Stop& stop);

/// Collapse: the `top` stacks go over to the other bed, from both ends inwards, each to a
/// parking needle or, round an end, to a hook. Expand: the parked stacks go back to hooks of
/// the other bed, from some place in their middle outwards, each by its own offset; then stacks
/// of the collapsed bed's ends may follow round those.
enum class Crossing { collapse, expand };

/// Appends what moves a run to a stop.
void append_move(CollapsingTube& state, HangingRun& run, const Stop& to);

/// Finds who goes when and where such that the least way is left in all, and then the passes are
/// fewest (best-first search over what has gone), and appends that to the plan. False if the
/// slack lets nobody go. Stacks that met are not made one yet.
/// Requires: for `expand` that not all stacks hang on hooks of the collapsed bed.
bool cross(CollapsingTube& state, Crossing crossing);

}  // namespace meshknit
