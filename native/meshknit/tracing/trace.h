#pragma once

#include "meshknit/core/run_context.h"
#include "meshknit/knit_graph/knit_graph.h"
#include "meshknit/tracing/stitch.h"

namespace meshknit {

/// Traces a knit graph into stitches by the paper's rules 1-6 (section 3.3; tracing_rules.h).
/// Requires: check_knit_graph(graph) finds no error.
/// Throws: NotKnittable if the graph violates a property that tracing needs; Cancelled.
/// Ensures: check_trace(graph, result) finds nothing; at most n + (k-1)m yarns.
StitchTrace trace_knit_graph(const KnitGraph& graph, RunContext* run = nullptr);

}  // namespace meshknit
