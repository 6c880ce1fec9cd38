#pragma once

#include <vector>

#include "meshknit/remesh/front.h"

namespace meshknit {

/// Distance of every vertex to the nearest marked one, out to `limit` mm, infinite beyond. Fast marching
/// (Kimmel and Sethian 1998): near enough for counting the rows that are left, and linear in the
/// strip where exact windows would multiply.
std::vector<double> distance_to(const PeelState& state, const std::vector<char>& marked,
                                double limit);

}  // namespace meshknit
