#pragma once

#include <vector>

namespace meshknit {

/// Can these cycles of loops hang on the two beds at once without any yarn being stretched?
///
/// A cycle lists columns (any numbers, each at most once per cycle) in anticlockwise order; a
/// column in two cycles is a loop that goes over from one to the other at a split or merge and
/// so hangs in one place for both (paper, Property 6: the function l). Each cycle must lie like
/// a tube: rightward along the front, leftward along the back, neighbours on adjacent needles
/// and at most one needle off across the beds. No two columns share a needle.
/// Requires: the cycles hang together through shared columns. Time: quadratic for one cycle
/// that shares all its columns (a plain split or merge); exponential in the number of cycles at
/// worst.
bool has_common_layout(const std::vector<std::vector<int>>& cycles);

}  // namespace meshknit
