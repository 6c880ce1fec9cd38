#pragma once

#include <vector>

#include "meshknit/surface/refine.h"

namespace meshknit {

/// Renumbers vertices by their value, and faces, edges and half edges after them, so that what is
/// visited together (a band of a sweep by value) lies together in memory. Ties keep their order.
/// Returns the new number of each old vertex.
std::vector<int> reorder_by_value(RefinedMesh& refined, RunContext* run = nullptr);

}  // namespace meshknit
