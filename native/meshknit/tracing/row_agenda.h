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
///
/// The last free yarn goes only where it comes free again before another is needed: to a tube that
/// ends, or that the next event waits for. If all yarns wait for their turn, one goes on ahead of it
/// where that makes no tubes cross.
class RowAgenda {
 public:
  /// No more than `most_yarns` are in use at once, unless tubes would cross, or a yarn that goes on
  /// above a split comes where tubes meet too early.
  /// `events`: the order in which tubes start, part, meet and end; empty for that of time.
  /// Requires: check_knit_graph(graph) finds no error; the graph's own tubes; most_yarns >= 1.
  RowAgenda(const KnitGraph& graph, const Tubes& tubes, std::vector<TubeEvent> events,
            int most_yarns);

  /// A yarn that may go on with this ready row.
  void wait(const YarnEnd& yarn, int row) { waiting_.push_back({yarn, row}); }

  /// What to do next: take up a yarn, or (yarn.yarn < 0) begin one in `row`. Row -1: all is done.
  struct Turn {
    YarnEnd yarn;
    int row = -1;
  };
  Turn next(const TraceState& state);

  /// True if all yarns were in use at some time, so that rows may have had to wait for one.
  bool ran_out() const { return ran_out_; }

 private:
  bool is_earlier(int row, int other) const;
  bool is_done(std::size_t event, const TraceState& state) const;
  int awaited_event(int row) const;
  bool may_be_early(int row) const;
  bool gives_back(int row) const;
  template <class May>
  Turn earliest_waiting(May may_go_on) const;
  template <class May>
  Turn earlier_of(Turn best, const TraceState& state, May may_bring_in) const;

  std::vector<double> time_;      ///< [row]: mean of its nodes
  std::vector<int> closed_rows_;  ///< that are not begun
  std::vector<Turn> waiting_;
  Tubes tubes_;
  std::vector<int> first_row_, last_row_;  ///< [tube] closed
  std::vector<std::vector<int>>
      begins_with_;                      ///< [event] first rows of the tubes that it begins
  std::vector<std::vector<int>> needs_;  ///< [event] tubes that must be knit for it
  std::vector<bool> ends_;               ///< [tube] nothing goes on above it
  std::vector<TubeEvent> events_;
  std::size_t next_event_ = 0;
  std::size_t most_yarns_;
  bool ran_out_ = false;
};

}  // namespace meshknit
