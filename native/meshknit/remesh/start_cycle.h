#pragma once

#include <vector>

#include "meshknit/remesh/front.h"

namespace meshknit {

/// The cycle just inside a boundary: it crosses the edges that leave the boundary's vertices,
/// very near to them. Sets `state.crossing` there.
Cycle cycle_beside(PeelState& state, const std::vector<char>& boundary);

}  // namespace meshknit
