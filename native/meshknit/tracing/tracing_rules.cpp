#include "meshknit/tracing/tracing_rules.h"

namespace meshknit {
namespace {

Direction reverse(Direction direction) {
  return direction == Direction::clockwise ? Direction::anticlockwise : Direction::clockwise;
}

bool at_row_end(const TraceState& state) {
  return state.ahead(state.node(), state.direction()) < 0;
}

void tuck_and_knit_in_reverse(TraceState& state, int node) {
  state.tuck();
  state.knit(node, reverse(state.direction()));
}

}  // namespace

bool start_yarn(TraceState& state) {
  for (int row = 0; row < static_cast<int>(state.graph().rows.size()); ++row) {
    const std::vector<int>& nodes = state.graph().rows[row].nodes;
    int first = -1;
    if (!state.is_begun(row)) {
      if (state.is_ready(row)) first = nodes.front();
    } else {
      for (const int node : nodes) {
        const int before = state.walk().previous(node);
        if (state.times_knit(node) == 1 && before >= 0 && state.times_knit(before) == 2)
          first = node;
        if (first >= 0) break;
      }
    }
    if (first < 0) continue;
    state.begin_yarn();
    state.knit(first, Direction::anticlockwise);
    return true;
  }
  return false;
}

bool move_to_next_row(TraceState& state) {
  if (state.times_knit(state.node()) < 2) return false;
  const std::vector<int>& above = state.walk().above(state.node());
  if (above.empty()) return false;
  const Direction direction = state.direction();
  const int ready = direction == Direction::anticlockwise ? above.back() : above.front();
  if (!state.is_ready(state.walk().place(ready).row)) return false;

  const int neighbour = state.ahead(ready, direction);
  if (neighbour >= 0) {
    state.knit(neighbour, direction);
  } else {
    tuck_and_knit_in_reverse(state, ready);
  }
  return true;
}

bool continue_row(TraceState& state) {
  const int next = state.ahead(state.node(), state.direction());
  if (next < 0 || state.times_knit(next) == 2) return false;
  state.knit(next, state.direction());
  return true;
}

bool tuck_and_turn(TraceState& state) {
  if (!at_row_end(state) || state.times_knit(state.node()) == 2) return false;
  tuck_and_knit_in_reverse(state, state.node());
  return true;
}

bool end_short_row(TraceState& state) {
  if (!at_row_end(state)) return false;
  const int next = state.node_due_ahead();
  if (next < 0) return false;
  state.knit(next, state.direction());
  return true;
}

void end_yarn(TraceState& state) { state.end_yarn(); }

}  // namespace meshknit
