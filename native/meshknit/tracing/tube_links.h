#pragma once

#include <vector>

#include "meshknit/knit_graph/knit_graph.h"
#include "meshknit/tracing/tube_events.h"
#include "meshknit/tracing/tubes.h"

namespace meshknit {

/// The Reeb graph of a knit graph: [tube] how it hangs together with the others. Times are means of
/// rows.
/// Requires: check_knit_graph(graph) finds no error; the graph's own tubes.
std::vector<TubeLinks> link_tubes(const KnitGraph& graph, const Tubes& tubes);

}  // namespace meshknit
