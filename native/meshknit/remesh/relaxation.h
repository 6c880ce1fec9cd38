#pragma once

#include <functional>
#include <vector>

#include "meshknit/knit_graph/knit_graph.h"
#include "meshknit/surface/triangle_mesh.h"

namespace meshknit {

/// Moves nodes over the surface so that row edges come nearer to l_r and column edges to 2 l_c
/// (Property 8): the incremental pass places rows exactly and leaves all of the error in
/// columns beside shaping. The graph's edges stay as they are, and so do the nodes of first and
/// last rows, which lie on boundaries. `faces` holds the triangle of every node, `time` the
/// knitting time of every mesh vertex; both positions and times of the nodes are updated.
/// `progress` is told the fraction that is done and may throw. Deterministic.
void relax_nodes(const TriangleMesh& mesh, const std::vector<double>& time,
                 std::vector<int>& faces, KnitGraph& graph,
                 const std::function<void(double)>& progress = {});

}  // namespace meshknit
