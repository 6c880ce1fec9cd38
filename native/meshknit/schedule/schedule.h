#pragma once

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

/// One construction step: a run of stitches on one tube in one direction that works no stack
/// twice, and the transfers before it. Before the step the tube holds `before` (stacks in
/// anticlockwise order, each on its hook `before_hooks`). The transfers bring stack i to hook
/// `moved_hooks[i]`; stacks with equal moved hook are decreased together, in the order in which
/// the step's direction meets them. Then stitches first..last (inclusive) are made. All other
/// tubes hang where they are. A step may be without stitches (last = first - 1, first the next one
/// to be made): it moves a tube that is in the way of others, or that will meet another.
///
/// The first step of a tube that starts holds nameless loops, which must be cast on just before it;
/// that of any other tube holds a part of the loops of a tube that splits, or all those of the
/// tubes that merge, on the hooks where they hang.
struct ScheduleStep {
  int tube = 0;
  int first_stitch = 0, last_stitch = -1;
  std::vector<LoopStack> before;
  std::vector<Hook> before_hooks;
  std::vector<Hook> moved_hooks;
  std::vector<Hook> stitch_hooks;       ///< where each stitch of the step is made
  std::vector<Hook> second_loop_hooks;  ///< of increases; otherwise the stitch's own hook
  /// Half-gauge places, inclusive, that no other tube uses: room for the transfers.
  int lowest_place = 0, highest_place = 0;
  /// Needles of the longest yarn between the beds on tubes beside it: what a racking adds must not
  /// stretch it too far.
  int bridge_beside = 1;
};

/// A tube that no other takes over: what it leaves on the machine after its last step, to be bound
/// off or knit on with waste before the next step.
struct TubeEnd {
  int tube = 0;
  int step = 0;                  ///< its last step, an index into Schedule::steps
  std::vector<LoopStack> loops;  ///< anticlockwise
  std::vector<Hook> hooks;
};

/// What the paper's section 3.4 counts, summed over steps.
struct LayoutCost {
  long alignment = 0, roll = 0, shift = 0;
};

struct Schedule {
  std::vector<ScheduleStep> steps;
  std::vector<TubeEnd> ends;  ///< in the order of their steps
  LayoutCost cost;
  bool optimal_order = true;  ///< no order of the tubes on the bed costs less
  bool optimal_moves = true;  ///< no tube moved otherwise than is best for it, to keep room
  bool optimal() const { return optimal_order && optimal_moves; }
  int segments = 0, connections = 0;
};

/// Lays the traced stitches on the beds (paper, section 3.4):
///  - the tubes side by side in an order in which none has to cross another (bed_order.h);
///  - per step the layout among the 4N (N odd) or 5N (N even) that takes fewest passes, then
///    shifts, over all tubes (layout_search.h says why not alignment first); where tubes part or
///    meet the layout fits all of them (connections.h);
///  - horizontal offsets so that all places lie on the machine's needles, and tubes that hang at
///    the same time have a place between them (needle_offsets.h).
/// A stack counts as one loop. Layouts are compared at the offset of least cost (layout_cost.h).
/// Requires: check_trace finds nothing for the trace.
/// Throws: NotKnittable "too-wide" naming the widest rows' nodes and the largest scale that fits;
/// "too-narrow" for a row of fewer than two loops; "stack-too-high" naming the nodes where tucks
/// and decreases pile up more loops than a needle holds; "tubes-cross", "tubes-not-side-by-side",
/// "loops-apart" (bed_order.h, connections.h, tube_steps.h); Cancelled.
/// Ensures: check_schedule(trace, result, profile) finds nothing. Not optimal is the order if not all
/// orders of the tubes could be tried, and the moves if tubes would walk off the bed or into each
/// other and some had to be worse than their best.
Schedule schedule_stitches(const StitchTrace& trace, const MachineProfile& profile,
                           RunContext* run = nullptr);

}  // namespace meshknit
