#pragma once

#include <vector>

#include "meshknit/surface/surface.h"

namespace meshknit {

/// The boundary loops of a mesh, in the order and direction that Surface promises.
std::vector<BoundaryLoop> boundary_loops(const TriangleMesh& mesh,
                                         const std::vector<int>& source_vertex);

}  // namespace meshknit
