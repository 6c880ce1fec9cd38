#pragma once

#include <optional>

#include "meshknit/transfer/pass_search.h"

namespace meshknit {

/// Where many loops must go round the ends of a tube, one turn after the other brings them there:
/// a turn hangs every stack where the second one after it (or before it) hangs now, the whole tube
/// up to two places aside. Four loops roll in it, two at either end, each in a pass of its own, and
/// the beds pass each other by four places, which one racking out and one back can do: six passes
/// where the tube moves two places aside, and back in the next turn. Collapse-shift-expand takes
/// five for a single loop.
///
/// Of the turns that take the fewest passes, the one that brings the tube nearest to where it
/// must hang in the end. None if less than three
/// loops must still go round each end, if they go both ways, or if the yarn between stacks, the
/// places that may be used or the shape of the tube forbid it.
/// Requires: not tube.arrived(); all stacks on hooks, no two on one.
std::optional<PassPlan> turn_by_two(const Tube& tube, PairWaysCache& cache);

}  // namespace meshknit
