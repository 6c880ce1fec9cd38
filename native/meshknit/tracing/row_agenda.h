#pragma once

#include <vector>

#include "meshknit/tracing/trace_state.h"

namespace meshknit {

/// Which closed row is knit next, where several tubes hang on the machine: the one of the earliest
/// time, so that sibling tubes grow together and no join waits for long (paper, section 5). A yarn
/// that reaches the end of a closed row waits here for its turn.
class RowAgenda {
 public:
  /// No more than `most_yarns` are in use at once.
  /// Requires: a graph that outlives the agenda, most_yarns >= 1.
  RowAgenda(const KnitGraph& graph, int most_yarns);

  /// A yarn that may go on with this ready row.
  void wait(const YarnEnd& yarn, int row) { waiting_.push_back({yarn, row}); }

  /// What to do next: take up a yarn, or (yarn.yarn < 0) begin one in `row`. Row -1: all is done.
  struct Turn {
    YarnEnd yarn;
    int row = -1;
  };
  Turn next(const TraceState& state);

 private:
  bool is_earlier(int row, int other) const;

  std::vector<double> time_;  ///< [row]: mean of its nodes
  std::vector<int> closed_rows_;
  std::vector<Turn> waiting_;
  std::size_t most_yarns_;
};

}  // namespace meshknit
