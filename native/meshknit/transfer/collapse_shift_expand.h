#pragma once

#include <optional>

#include "meshknit/transfer/pass_search.h"

namespace meshknit {

/// The way that still lies before a stack of this tube, in places, and 2 for every end that it
/// must go round (knitout primer, 4.1).
long remaining_way(const Tube& tube, const Stack& stack, const Stop& stop);

/// One iteration of collapse-shift-expand: a pass that collapses stacks from one bed onto the
/// other, one that brings stacks over with a shift, and one that expands again; in each of them
/// a stack may also stay, and a stack at an end may go round it. Of all rackings of the three,
/// those with the least remaining way of the whole tube. None if nothing brings the tube nearer
/// to its goal.
std::optional<PassPlan> collapse_shift_expand(const Tube& tube);

}  // namespace meshknit
