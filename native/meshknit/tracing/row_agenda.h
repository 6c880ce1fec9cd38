#pragma once

#include <vector>

#include "meshknit/tracing/event_order.h"
#include "meshknit/tracing/trace_state.h"
#include "meshknit/tracing/tubes.h"

namespace meshknit {

/// Which closed row is knit next, where several tubes hang on the machine: the one of the earliest
/// time, so that sibling tubes grow together and no join waits for long (paper, section 5). Where
/// tubes would cross that way, they start, part and meet in an order in which they do not
/// (event_order.h). A yarn that reaches the end of a closed row waits here for its turn.
class RowAgenda {
 public:
  /// No more than `most_yarns` are in use at once, unless tubes would cross.
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
  bool is_done(std::size_t event, const TraceState& state) const;
  bool may_begin(int row) const;
  Turn earliest(const TraceState& state, bool may_bring_in) const;

  std::vector<double> time_;      ///< [row]: mean of its nodes
  std::vector<int> closed_rows_;  ///< that are not begun
  std::vector<Turn> waiting_;
  Tubes tubes_;
  std::vector<int> first_row_, last_row_;  ///< [tube] closed
  std::vector<std::vector<int>>
      begins_with_;  ///< [event] first rows of the tubes that it begins
  std::vector<TubeEvent> events_;
  std::size_t next_event_ = 0;
  std::size_t most_yarns_;
};

}  // namespace meshknit
