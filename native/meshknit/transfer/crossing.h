#pragma once

#include "meshknit/transfer/collapsing_tube.h"

namespace meshknit {

/// Collapse: the `top` stacks go over to the other bed, from both ends inwards, each to a
/// parking needle or, round an end, to a hook. Expand: the parked stacks go back to hooks of
/// the other bed, from some place in their middle outwards, each by its own offset; then stacks
/// of the collapsed bed's ends may follow round those.
enum class Crossing { collapse, expand };

/// Finds who goes when and where such that the least way is left in all, and then the passes are
/// fewest (best-first search over what has gone), and appends that to the plan. False if the
/// slack lets nobody go. Stacks that met are not made one yet.
/// Requires: for `expand` that not all stacks hang on hooks of the collapsed bed.
bool cross(CollapsingTube& state, Crossing crossing);

}  // namespace meshknit
