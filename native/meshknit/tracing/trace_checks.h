#pragma once

#include "meshknit/core/problem.h"
#include "meshknit/knit_graph/knit_graph.h"
#include "meshknit/tracing/stitch.h"

namespace meshknit {

/// Everything a trace promises: parents and children agree and stand in loop order, kinds fit
/// their numbers, every node knit exactly twice, every loop knit through exactly once (but
/// those of end stitches), loops follow the graph's columns, tucks at both ends of every short
/// row and nowhere else, yarn steps go to neighbours, at most n + (k-1)m yarns. Each problem
/// names stitches and nodes; trace_promises.h says which codes there are.
/// Requires: check_knit_graph(graph) finds no error.
Problems check_trace(const KnitGraph& graph, const StitchTrace& trace);

}  // namespace meshknit
