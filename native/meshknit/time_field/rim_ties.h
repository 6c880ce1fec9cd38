#pragma once

#include <vector>

#include "meshknit/surface/triangle_mesh.h"

namespace meshknit {

/// Moves inner vertices that share the time of a boundary beside them a little towards their other
/// neighbours, so that level sets near the boundary go round it and not over edges that lead from
/// one of its vertices to another. No vertex becomes an extremum or stops being one.
void part_from_rims(const TriangleMesh& mesh, std::vector<double>& time);

}  // namespace meshknit
