#include "meshknit/tracing/row_agenda.h"

#include <algorithm>

namespace meshknit {

RowAgenda::RowAgenda(const KnitGraph& graph, int most_yarns)
    : tubes_(find_tubes(graph)),
      first_row_(tubes_.count, -1),
      last_row_(tubes_.count, -1),
      events_(find_event_order(graph, tubes_, most_yarns)),
      most_yarns_(static_cast<std::size_t>(most_yarns)) {
  for (int row = 0; row < static_cast<int>(graph.rows.size()); ++row) {
    double sum = 0.0;
    for (const int node : graph.rows[row].nodes) sum += graph.nodes[node].time;
    time_.push_back(sum / static_cast<double>(graph.rows[row].nodes.size()));
    if (!graph.rows[row].closed) continue;
    closed_rows_.push_back(row);
    const int tube = tubes_.of_row[row];
    if (first_row_[tube] < 0) first_row_[tube] = row;
    last_row_[tube] = row;
  }
  const RowWalk walk(graph);
  for (const TubeEvent& event : events_) {
    begins_with_.emplace_back();
    if (event.kind == TubeEvent::Kind::end) continue;
    if (event.kind != TubeEvent::Kind::split) {
      begins_with_.back() = {first_row_[event.tube]};
      continue;
    }
    for (const int node : graph.rows[last_row_[event.tube]].nodes)
      for (const int above : walk.above(node))
        begins_with_.back().push_back(walk.place(above).row);
  }
}

bool RowAgenda::is_earlier(int row, int other) const {
  if (other < 0) return true;
  return time_[row] < time_[other] || (time_[row] == time_[other] && row < other);
}

bool RowAgenda::is_done(std::size_t event, const TraceState& state) const {
  if (events_[event].kind == TubeEvent::Kind::end)
    return state.is_complete(last_row_[events_[event].tube]);
  const std::vector<int>& rows = begins_with_[event];
  return std::any_of(rows.begin(), rows.end(), [&](int row) { return state.is_begun(row); });
}

// A tube begins when all events before its own are done.
bool RowAgenda::may_begin(int row) const {
  if (first_row_[tubes_.of_row[row]] != row) return true;
  for (std::size_t e = next_event_ + 1; e < events_.size(); ++e)
    if (std::count(begins_with_[e].begin(), begins_with_[e].end(), row) > 0) return false;
  return true;
}

RowAgenda::Turn RowAgenda::earliest(const TraceState& state, bool may_bring_in) const {
  Turn best;
  for (const Turn& turn : waiting_)
    if (may_begin(turn.row) && is_earlier(turn.row, best.row)) best = turn;
  if (!may_bring_in) return best;
  for (const int row : closed_rows_) {
    const bool spoken_for = std::any_of(waiting_.begin(), waiting_.end(),
                                        [&](const Turn& turn) { return turn.row == row; });
    if (state.is_ready(row) && !spoken_for && may_begin(row) && is_earlier(row, best.row))
      best = {{}, row};
  }
  return best;
}

RowAgenda::Turn RowAgenda::next(const TraceState& state) {
  closed_rows_.erase(std::remove_if(closed_rows_.begin(), closed_rows_.end(),
                                    [&](int row) { return state.is_begun(row); }),
                     closed_rows_.end());
  while (next_event_ < events_.size() && is_done(next_event_, state)) ++next_event_;
  Turn best = earliest(state, waiting_.size() < most_yarns_);
  if (best.row < 0) best = earliest(state, true);
  if (best.yarn.yarn >= 0)
    waiting_.erase(std::find_if(waiting_.begin(), waiting_.end(), [&](const Turn& turn) {
      return turn.yarn.yarn == best.yarn.yarn;
    }));
  return best;
}

}  // namespace meshknit
