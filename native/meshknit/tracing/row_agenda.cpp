#include "meshknit/tracing/row_agenda.h"

#include <algorithm>

namespace meshknit {

RowAgenda::RowAgenda(const KnitGraph& graph, int most_yarns)
    : most_yarns_(static_cast<std::size_t>(most_yarns)) {
  for (int row = 0; row < static_cast<int>(graph.rows.size()); ++row) {
    double sum = 0.0;
    for (const int node : graph.rows[row].nodes) sum += graph.nodes[node].time;
    time_.push_back(sum / static_cast<double>(graph.rows[row].nodes.size()));
    if (graph.rows[row].closed) closed_rows_.push_back(row);
  }
}

bool RowAgenda::is_earlier(int row, int other) const {
  if (other < 0) return true;
  return time_[row] < time_[other] || (time_[row] == time_[other] && row < other);
}

RowAgenda::Turn RowAgenda::next(const TraceState& state) {
  closed_rows_.erase(std::remove_if(closed_rows_.begin(), closed_rows_.end(),
                                    [&](int row) { return state.is_begun(row); }),
                     closed_rows_.end());
  Turn best;
  if (waiting_.size() < most_yarns_)
    for (const int row : closed_rows_) {
      const bool spoken_for = std::any_of(waiting_.begin(), waiting_.end(),
                                          [&](const Turn& turn) { return turn.row == row; });
      if (state.is_ready(row) && !spoken_for && is_earlier(row, best.row)) best.row = row;
    }
  const auto none = waiting_.end();
  auto taken = none;
  for (auto turn = waiting_.begin(); turn != none; ++turn)
    if (is_earlier(turn->row, best.row)) {
      best = *turn;
      taken = turn;
    }
  if (taken != none) waiting_.erase(taken);
  return best;
}

}  // namespace meshknit
