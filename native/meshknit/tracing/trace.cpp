#include "meshknit/tracing/trace.h"

#include <algorithm>
#include <string>
#include <utility>
#include <vector>

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

StitchTrace trace_in_order(const KnitGraph& graph, RowAgenda& agenda, RunContext* run) {
  TraceState state(graph);
  const auto expected = static_cast<double>(2 * graph.nodes.size());
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
  return state.take_trace();
}

int most_yarns_in_use(const StitchTrace& trace) {
  std::vector<int> last(trace.yarns, -1);
  for (int s = 0; s < static_cast<int>(trace.stitches.size()); ++s)
    last[trace.stitches[s].yarn] = s;
  std::vector<bool> in(trace.yarns, false);
  int now = 0, most = 0;
  for (int s = 0; s < static_cast<int>(trace.stitches.size()); ++s) {
    const int yarn = trace.stitches[s].yarn;
    if (!in[yarn]) most = std::max(most, ++now);
    in[yarn] = true;
    if (s == last[yarn]) --now;
  }
  return most;
}

}  // namespace

StitchTrace trace_knit_graph(const KnitGraph& graph, int most_yarns, RunContext* run) {
  if (most_yarns < 1) throw InvalidInput("tracing needs at least one yarn");
  require_traceable(graph);
  report(run, 0.0);
  const Tubes tubes = find_tubes(graph);
  RowAgenda agenda(graph, tubes, find_event_order(graph, tubes, most_yarns), most_yarns);
  StitchTrace best = trace_in_order(graph, agenda, run);
  if (agenda.ran_out()) {
    // Tubes that wait for a yarn may come to hang between others that meet, and tubes that wait for
    // their turn keep theirs: another order may do better.
    const auto faults = [&](const StitchTrace& trace) {
      return std::make_pair(tubes_cross(graph, tubes, trace),
                            std::max(0, most_yarns_in_use(trace) - most_yarns));
    };
    for (const std::vector<TubeEvent>& order : more_event_orders(graph, tubes)) {
      if (faults(best) == std::make_pair(false, 0)) break;
      RowAgenda other_agenda(graph, tubes, order, most_yarns);
      StitchTrace other = trace_in_order(graph, other_agenda, run);
      if (faults(other) < faults(best)) best = std::move(other);
    }
  }
  report(run, 1.0);
  return best;
}

}  // namespace meshknit
