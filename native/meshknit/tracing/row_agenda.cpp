#include "meshknit/tracing/row_agenda.h"

#include <algorithm>
#include <utility>

namespace meshknit {

RowAgenda::RowAgenda(const KnitGraph& graph, const Tubes& tubes, std::vector<TubeEvent> events,
                     int most_yarns)
    : tubes_(tubes),
      first_row_(tubes_.count, -1),
      last_row_(tubes_.count, -1),
      ends_(tubes_.count, false),
      events_(std::move(events)),
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
    std::vector<int> rows, needs{event.tube};
    switch (event.kind) {
      case TubeEvent::Kind::start:
        rows = {first_row_[event.tube]};
        break;
      case TubeEvent::Kind::split:
        for (const int node : graph.rows[last_row_[event.tube]].nodes)
          for (const int above : walk.above(node)) rows.push_back(walk.place(above).row);
        break;
      case TubeEvent::Kind::merge:
        rows = {first_row_[event.tube]};
        for (const int node : graph.rows[first_row_[event.tube]].nodes)
          for (const int below : walk.below(node))
            needs.push_back(tubes_.of_row[walk.place(below).row]);
        break;
      case TubeEvent::Kind::end:
        ends_[event.tube] = true;
        break;
    }
    begins_with_.push_back(std::move(rows));
    needs_.push_back(std::move(needs));
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

// A tube begins when all events before its own are done. The one that this row must wait for; -1 if it
// may be begun.
int RowAgenda::awaited_event(int row) const {
  if (first_row_[tubes_.of_row[row]] != row) return -1;
  for (std::size_t e = next_event_ + 1; e < events_.size(); ++e)
    if (std::count(begins_with_[e].begin(), begins_with_[e].end(), row) > 0)
      return static_cast<int>(e);
  return -1;
}

// Tubes that part cross no more than before. Nor do tubes that meet, unless another hangs between them,
// which then ends before.
bool RowAgenda::may_be_early(int row) const {
  const int event = awaited_event(row);
  if (event < 0 || events_[event].kind == TubeEvent::Kind::split) return true;
  const auto first = events_.begin() + static_cast<long>(next_event_);
  return std::none_of(first, events_.begin() + event, [](const TubeEvent& before) {
    return before.kind == TubeEvent::Kind::end;
  });
}

// A yarn brought in for this row comes free again before another one is needed.
bool RowAgenda::gives_back(int row) const {
  if (next_event_ >= events_.size()) return true;
  const int tube = tubes_.of_row[row];
  const std::vector<int>& needed = needs_[next_event_];
  return ends_[tube] || std::count(needed.begin(), needed.end(), tube) > 0;
}

template <class May>
RowAgenda::Turn RowAgenda::earliest_waiting(May may_go_on) const {
  Turn best;
  for (const Turn& turn : waiting_)
    if (may_go_on(turn.row) && is_earlier(turn.row, best.row)) best = turn;
  return best;
}

// This turn, or a yarn brought in for an earlier row.
template <class May>
RowAgenda::Turn RowAgenda::earlier_of(Turn best, const TraceState& state,
                                      May may_bring_in) const {
  for (const int row : closed_rows_) {
    const bool spoken_for = std::any_of(waiting_.begin(), waiting_.end(),
                                        [&](const Turn& turn) { return turn.row == row; });
    if (state.is_ready(row) && !spoken_for && awaited_event(row) < 0 &&
        is_earlier(row, best.row) && may_bring_in(row))
      best = {{}, row};
  }
  return best;
}

RowAgenda::Turn RowAgenda::next(const TraceState& state) {
  closed_rows_.erase(std::remove_if(closed_rows_.begin(), closed_rows_.end(),
                                    [&](int row) { return state.is_begun(row); }),
                     closed_rows_.end());
  while (next_event_ < events_.size() && is_done(next_event_, state)) ++next_event_;
  ran_out_ = ran_out_ || waiting_.size() >= most_yarns_;
  Turn best = earliest_waiting([&](int row) { return awaited_event(row) < 0; });
  if (waiting_.size() + 1 < most_yarns_)
    best = earlier_of(best, state, [](int) { return true; });
  else if (waiting_.size() < most_yarns_)
    best = earlier_of(best, state, [&](int row) { return gives_back(row); });
  if (best.row < 0) best = earliest_waiting([&](int row) { return may_be_early(row); });
  if (best.row < 0) best = earlier_of(best, state, [](int) { return true; });
  if (best.yarn.yarn >= 0)
    waiting_.erase(std::find_if(waiting_.begin(), waiting_.end(), [&](const Turn& turn) {
      return turn.yarn.yarn == best.yarn.yarn;
    }));
  return best;
}

}  // namespace meshknit
