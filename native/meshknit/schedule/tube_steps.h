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

/// A stack of the ring with which a tube ended.
struct EndStack {
  int tube = -1, stack = -1;
};

/// A tube, step by step. The slots of a step are the stacks of the next one, under the same
/// numbers.
struct TubeSteps {
  std::vector<TubeStep> steps;
  std::vector<LoopStack> end;     ///< what hangs on the machine after the last step
  std::vector<EndStack> origins;  ///< of the first step's stacks; empty where the object starts
  std::vector<int> below,
      above;  ///< tubes whose loops it takes over, and that take over its own
};

/// All tubes of an object (the segments of the paper's section 3.4), under the trace's numbers.
struct SteppedTubes {
  struct Turn {
    int tube = 0, step = 0;
  };
  std::vector<TubeSteps> tubes;
  std::vector<Turn> turns;  ///< the steps of all tubes in the order of knitting
};

/// Replays the trace, keeping the stacks of every tube in anticlockwise order. A step is as long
/// as possible: stitches on one tube in one direction (a tuck at a turn belongs to the direction
/// before the turn), no stack worked twice. Before its first step a tube that starts holds one
/// nameless loop (of waste) for each start stitch; any other holds the loops that its first round
/// is knit through.
/// Throws: NotKnittable "loops-apart" for stitches whose parents do not hang side by side on their
/// tube; "too-narrow" if a tube has fewer than two stacks at some time. Both name stitches and
/// nodes.
SteppedTubes replay_tubes(const StitchTrace& trace);

/// The loops that a stitch is knit through, in the order of its parents (empty for a tuck).
std::vector<LoopName> parent_loops(const StitchTrace& trace, int stitch);

/// The loop that a tuck lies on: stitch -1 if its child does not name it after another stitch.
LoopName tucked_loop(const StitchTrace& trace, int tuck);

}  // namespace meshknit
