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

/// The node above the current one whose row may be begun now; -1 if there is none.
int node_to_move_to(const TraceState& state) {
  const int node = state.node();
  if (state.times_knit(node) < 2) return -1;
  const std::vector<int>& above = state.walk().above(node);
  if (above.empty()) return -1;
  const int ready =
      state.direction() == Direction::anticlockwise ? above.back() : above.front();
  const int row = state.walk().place(ready).row, below = state.walk().place(node).row;
  if (!state.is_ready(row)) return -1;
  const std::vector<KnitRow>& rows = state.graph().rows;
  const bool half_done = rows[row].closed && rows[below].closed && !state.is_complete(below);
  return half_done ? -1 : ready;
}

}  // namespace

void start_yarn(TraceState& state, int row) {
  state.begin_yarn();
  state.knit(state.graph().rows[row].nodes.front(), Direction::anticlockwise);
}

int row_to_move_to(const TraceState& state) {
  const int above = node_to_move_to(state);
  return above < 0 ? -1 : state.walk().place(above).row;
}

bool move_to_next_row(TraceState& state) {
  const int ready = node_to_move_to(state);
  if (ready < 0) return false;
  const Direction direction = state.direction();
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
