#pragma once

#include <vector>

#include "meshknit/knit_graph/knit_graph.h"
#include "meshknit/knit_graph/rows.h"
#include "meshknit/tracing/loop_ring.h"
#include "meshknit/tracing/stitch.h"
#include "meshknit/tracing/tubes.h"

namespace meshknit {

/// Where a yarn waits while another one is worked.
struct YarnEnd {
  int yarn = -1;
  int node = -1;  ///< of its last stitch
  Direction direction = Direction::anticlockwise;
};

/// What tracing knows while it goes along: how often every node is knit, which loops hang
/// beside each other, and where the current yarn is. The rules (tracing_rules.h) look at it and
/// make stitches with it.
/// Requires: a graph with Properties 1-5 that outlives the state.
class TraceState {
 public:
  explicit TraceState(const KnitGraph& graph);

  const KnitGraph& graph() const { return graph_; }
  const RowWalk& walk() const { return walk_; }
  const StitchTrace& trace() const { return trace_; }

  /// How many of a node's two stitches are made.
  int times_knit(int node) const { return times_knit_[node]; }
  /// All nodes below this row are knit twice.
  bool is_ready(int row) const { return waiting_[row] == 0; }
  bool is_begun(int row) const { return begun_[row]; }
  /// All of its own nodes are knit twice.
  bool is_complete(int row) const { return unfinished_[row] == 0; }

  int node() const { return node_; }  ///< of the current yarn's last stitch
  Direction direction() const { return direction_; }
  /// The node after this one in a direction of travel; -1 at the end of a short row.
  int ahead(int node, Direction direction) const;
  /// The node to be knit through the loop that hangs ahead of the current stitch: the loop's
  /// own node for the second time, or the one above it if that row is begun. -1 if the loop is
  /// not due.
  int node_due_ahead() const;

  void begin_yarn();
  void end_yarn() { node_ = -1; }
  /// The current yarn, to be taken up again later.
  YarnEnd yarn_end() const { return {yarn_, node_, direction_}; }
  void take_up(const YarnEnd& yarn);

  /// Knits a node with the current yarn, for the first or second time: through the loops below
  /// it (or its own first one).
  void knit(int node, Direction direction);
  /// Tucks on the loop that hangs ahead of the current stitch.
  void tuck();

  /// Hands the result over; the state is used up.
  StitchTrace take_trace();

 private:
  /// The loops of one node, in anticlockwise order.
  struct NodeLoops {
    int count = 0;
    int loop[2] = {-1, -1};
  };
  /// Which loop of which stitch, and the tucks that lie on it.
  struct LoopOwner {
    int stitch = -1;
    int child_slot = 0;
    std::vector<int> tucks;
  };

  int loop_ahead() const;
  int loop_under(int below, int node) const;
  std::vector<int> loops_under(int node) const;
  void close_ring_under(int row);
  void hang_new_loops(int node, int stitch, const std::vector<int>& knit_through);

  const KnitGraph& graph_;
  RowWalk walk_;
  StitchTrace trace_;
  LoopRing ring_;
  std::vector<LoopOwner> owners_;  ///< [loop]
  std::vector<NodeLoops> loops_;   ///< [node]
  std::vector<int> times_knit_;    ///< [node]
  std::vector<int> waiting_;       ///< [row]: columns from nodes that are not knit twice
  std::vector<int> unfinished_;    ///< [row]: nodes that are not knit twice
  std::vector<bool> begun_;        ///< [row]
  Tubes tubes_;
  int yarn_ = -1;
  int node_ = -1;
  Direction direction_ = Direction::anticlockwise;
};

}  // namespace meshknit
