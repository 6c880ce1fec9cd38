#pragma once

#include <optional>

#include "meshknit/transfer/pass_search.h"

namespace meshknit {

/// Two passes one way and one the other, in which every stack may go or stay and those at an end
/// may go round it. Of all such passes, those with the least remaining way of the whole tube. None
/// if nothing brings the tube nearer to its goal.
///
/// Slower than collapse_shift_expand, but gives any order of arrival: stacks may wait.
std::optional<PassPlan> three_passes(const Tube& tube);

}  // namespace meshknit
