#pragma once

#include <array>
#include <vector>

#include "meshknit/core/run_context.h"
#include "meshknit/machine/machine_profile.h"
#include "meshknit/machine/needle.h"
#include "meshknit/tracing/stitch.h"

namespace meshknit {

/// A hook in half-gauge places.
struct Hook {
  Bed bed = Bed::front;
  int n = 0;
  friend bool operator==(const Hook& a, const Hook& b) { return a.bed == b.bed && a.n == b.n; }
};

/// A loop that hangs on the machine: `which` is 1 for the second loop (the reverse tuck) of an
/// increase, else 0. A loop of waste, through which the object is begun, has no stitch (-1).
struct LoopName {
  int stitch = -1;
  int which = 0;
};

/// The loops of one needle, earliest arrival first: a loop, tucks that lie on it, a decrease's
/// second loop.
using LoopStack = std::vector<LoopName>;

/// One construction step: a run of stitches in one direction that works no stack twice, and the
/// transfers before it. Before the step the tube holds `before` (stacks in anticlockwise order,
/// each on its hook `before_hooks`). The transfers bring stack i to hook `moved_hooks[i]`;
/// stacks with equal moved hook are decreased together, in the order in which the step's
/// direction meets them. Then stitches first..last (inclusive) are made.
struct ScheduleStep {
  int first_stitch = 0, last_stitch = -1;
  std::vector<LoopStack> before;
  std::vector<Hook> before_hooks;
  std::vector<Hook> moved_hooks;
  std::vector<Hook> stitch_hooks;       ///< where each stitch of the step is made
  std::vector<Hook> second_loop_hooks;  ///< of increases; otherwise the stitch's own hook
};

/// Lexicographic cost of the paper's section 3.4, summed over steps.
struct LayoutCost {
  long alignment = 0, roll = 0, shift = 0;
};

struct Schedule {
  std::vector<ScheduleStep> steps;
  std::vector<LoopStack> end;  ///< what hangs on the machine after the last step, anticlockwise
  std::vector<Hook> end_hooks;
  LayoutCost cost;
  bool optimal = true;
  int segments = 1, connections = 0;
};

/// Lays the traced stitches of one tube on the beds (paper, section 3.4): per step the layout
/// among the 4N (N odd) or 5N (N even) that minimises alignment, then roll, then shift, over
/// the whole tube; then a horizontal offset so that all places lie on the machine's needles. A
/// stack counts as one loop. Layouts are compared at the offset that moves fewest loops; but
/// moves by more than two places, which no single racking makes, are avoided before shifts.
/// Requires: check_trace finds nothing for the trace.
/// Throws: NotKnittable "too-wide" naming the widest row's nodes and the largest scale that
/// fits; "too-narrow" for a row of fewer than two loops; "stack-too-high" naming the nodes
/// where tucks and decreases pile up more loops than a needle holds; "needs-one-tube" for more
/// than one yarn, start, split or merge; Cancelled.
/// Ensures: check_schedule(trace, result, profile) finds nothing. `optimal` is false if the
/// tube would walk off the bed and some moves had to be worse than their best to keep it there.
Schedule schedule_stitches(const StitchTrace& trace, const MachineProfile& profile,
                           RunContext* run = nullptr);

}  // namespace meshknit
