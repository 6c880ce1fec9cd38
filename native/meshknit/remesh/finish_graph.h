#pragma once

#include <vector>

#include "meshknit/knit_graph/knit_graph.h"
#include "meshknit/surface/triangle_mesh.h"

namespace meshknit {

/// Puts the columns of a peeled graph in their documented order and measures the surface length
/// of every row and column edge. `faces` holds the triangle of every node.
void finish_graph(const TriangleMesh& mesh, const std::vector<int>& faces, KnitGraph& graph);

}  // namespace meshknit
