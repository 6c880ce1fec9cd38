#pragma once

#include <vector>

#include "meshknit/schedule/schedule.h"
#include "meshknit/schedule/slot_map.h"
#include "meshknit/tracing/stitch.h"

namespace meshknit {

/// One construction step of a tube, before any needle is chosen (see ScheduleStep).
struct TubeStep {
  int first_stitch = 0, last_stitch = -1;
  std::vector<LoopStack> before;  ///< anticlockwise
  SlotMap map;                    ///< from `before` to the slots in which the step is knit
  std::vector<int> stitch_slot;   ///< slot of each stitch, 0 <= slot < map.slots()
  std::vector<int>
      second_slot;  ///< of an increase's second loop; otherwise the stitch's own slot
};

/// A tube, step by step. The slots of a step are the stacks of the next one, under the same
/// numbers.
struct TubeSteps {
  std::vector<TubeStep> steps;
  std::vector<LoopStack> end;  ///< what hangs on the machine after the last step
};

/// Replays the trace, keeping the stacks of its one tube in anticlockwise order. A step is as
/// long as possible: stitches in one direction (a tuck at a turn belongs to the direction
/// before the turn), no stack worked twice. Before the first step the tube holds one nameless
/// loop (of waste) for each start stitch.
/// Throws: NotKnittable "needs-one-tube" for more than one yarn or start, or stitches whose
/// parents do not hang side by side; "too-narrow" if the tube has fewer than two stacks at some
/// time. Both name stitches and nodes.
TubeSteps replay_tube(const StitchTrace& trace);

/// The loops that a stitch is knit through, in the order of its parents (empty for a tuck).
std::vector<LoopName> parent_loops(const StitchTrace& trace, int stitch);

/// The loop that a tuck lies on: stitch -1 if its child does not name it after another stitch.
LoopName tucked_loop(const StitchTrace& trace, int tuck);

}  // namespace meshknit
