#pragma once

#include <optional>
#include <vector>

#include "meshknit/transfer/pass.h"
#include "meshknit/transfer/stop.h"
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
  int top = 0;               ///< how many runs hang on hooks of the bed that is collapsed
  TransferPlan plan;         ///< so far
  std::optional<Pass> pass;  ///< the last one of the plan

  int count() const { return static_cast<int>(hanging.size()); }
};

/// Appends what moves a run to a stop.
void append_move(CollapsingTube& state, HangingRun& run, const Stop& to);

}  // namespace meshknit
