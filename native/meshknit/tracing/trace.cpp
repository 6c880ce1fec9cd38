#include "meshknit/tracing/trace.h"

#include <algorithm>

#include "meshknit/core/error.h"
#include "meshknit/knit_graph/knit_graph_checks.h"
#include "meshknit/tracing/tracing_rules.h"

namespace meshknit {
namespace {

/// The properties that the rules rely on. What a machine can hold (Property 6) is not their
/// concern.
void require_traceable(const KnitGraph& graph) {
  using Check = Problems (*)(const KnitGraph&);
  for (const Check check :
       {Check(check_graph_form), Check(check_helix_free), Check(check_consistent_orientation),
        Check(check_node_degree), Check(check_simple_short_rows), Check(check_simple_splits)}) {
    const Problems problems = check(graph);
    if (has_errors(problems)) throw NotKnittable(problems);
  }
}

bool follow_yarn(TraceState& state) {
  return move_to_next_row(state) || continue_row(state) || tuck_and_turn(state) ||
         end_short_row(state);
}

}  // namespace

StitchTrace trace_knit_graph(const KnitGraph& graph, RunContext* run) {
  require_traceable(graph);
  TraceState state(graph);
  const std::size_t expected = 2 * graph.nodes.size();
  const std::size_t report_every = 1000;
  report(run, 0.0);
  std::size_t next_report = report_every;
  while (start_yarn(state)) {
    while (follow_yarn(state)) {
      const std::size_t made = state.trace().stitches.size();
      if (made < next_report) continue;
      report(run, static_cast<double>(made) / static_cast<double>(expected));
      next_report = made + report_every;
    }
    end_yarn(state);
  }
  for (int node = 0; node < static_cast<int>(graph.nodes.size()); ++node)
    if (state.times_knit(node) != 2)
      throw BrokenPromise("tracing did not reach node " + std::to_string(node));
  report(run, 1.0);
  return state.take_trace();
}

}  // namespace meshknit
