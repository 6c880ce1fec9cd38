#pragma once

#include <functional>
#include <vector>

#include "meshknit/knit_graph/knit_graph.h"
#include "meshknit/surface/triangle_mesh.h"

namespace meshknit {

/// Brings edges nearer to the stitch's size (Property 8) after the incremental pass: nodes are relaxed
/// (relaxation.h), stitches are added where they are missing (add_stitches.h), and nodes are
/// relaxed again. Arguments as for relax_nodes; the graph's nodes are numbered anew.
/// Requires: check_knit_graph(graph) finds no errors, but lengths may be missing.
/// Ensures: the same of the result, with the same tubes, splits and merges.
void even_edges(const TriangleMesh& mesh, const std::vector<double>& time,
                std::vector<int>& faces, KnitGraph& graph,
                const std::function<void(double)>& progress = {});

}  // namespace meshknit
