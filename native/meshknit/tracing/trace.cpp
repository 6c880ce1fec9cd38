#include "meshknit/tracing/trace.h"

#include <algorithm>

#include "meshknit/core/error.h"
#include "meshknit/knit_graph/knit_graph_checks.h"
#include "meshknit/tracing/row_agenda.h"
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

/// The closed row that the current yarn is about to begin; -1 if it goes on otherwise.
int closed_row_ahead(const TraceState& state) {
  const int row = row_to_move_to(state);
  return row >= 0 && state.graph().rows[row].closed ? row : -1;
}

/// Works the current yarn until it has come to the end of a closed row, or cannot go on.
void knit_to_row_end(TraceState& state, RowAgenda& agenda) {
  while (true) {
    if (const int row = closed_row_ahead(state); row >= 0) {
      agenda.wait(state.yarn_end(), row);
      return;
    }
    if (!follow_yarn(state)) {
      end_yarn(state);
      return;
    }
  }
}

}  // namespace

StitchTrace trace_knit_graph(const KnitGraph& graph, int most_yarns, RunContext* run) {
  if (most_yarns < 1) throw InvalidInput("tracing needs at least one yarn");
  require_traceable(graph);
  TraceState state(graph);
  RowAgenda agenda(graph, most_yarns);
  const auto expected = static_cast<double>(2 * graph.nodes.size());
  report(run, 0.0);
  for (RowAgenda::Turn turn = agenda.next(state); turn.row >= 0; turn = agenda.next(state)) {
    if (turn.yarn.yarn < 0) {
      start_yarn(state, turn.row);
    } else {
      state.take_up(turn.yarn);
      move_to_next_row(state);
    }
    knit_to_row_end(state, agenda);
    report(run, std::min(1.0, static_cast<double>(state.trace().stitches.size()) / expected));
  }
  for (int node = 0; node < static_cast<int>(graph.nodes.size()); ++node)
    if (state.times_knit(node) != 2)
      throw BrokenPromise("tracing did not reach node " + std::to_string(node));
  report(run, 1.0);
  return state.take_trace();
}

}  // namespace meshknit
