#pragma once

#include "meshknit/core/run_context.h"
#include "meshknit/knit_graph/knit_graph.h"
#include "meshknit/tracing/stitch.h"

namespace meshknit {

/// Traces a knit graph into stitches by the paper's rules 1-6 (section 3.3; tracing_rules.h).
/// Tubes that hang side by side grow together, row by row in the order of time, with at most
/// `most_yarns` in use at once. If no order of those tried needs so few and lets no tubes cross, that
/// no tubes cross comes first.
/// Requires: check_knit_graph(graph) finds no error.
/// Throws: InvalidInput if most_yarns < 1; NotKnittable if the graph violates a property that
/// tracing needs; Cancelled.
/// Ensures: check_trace(graph, result) finds nothing; at most n + (k-1)m yarns.
StitchTrace trace_knit_graph(const KnitGraph& graph, int most_yarns, RunContext* run = nullptr);

/// The same with as many yarns as a machine of ten carriers has for an object.
inline StitchTrace trace_knit_graph(const KnitGraph& graph, RunContext* run = nullptr) {
  return trace_knit_graph(graph, 9, run);
}

}  // namespace meshknit
