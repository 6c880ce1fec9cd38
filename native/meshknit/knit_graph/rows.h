#pragma once

#include <vector>

#include "meshknit/knit_graph/knit_graph.h"

namespace meshknit {

/// Where a node sits in its row.
struct RowPlace {
  int row = -1;
  int index = -1;
};

/// Neighbours in a knit graph, ready to walk. -1 stands for "none".
/// Requires the shape that `check_graph_form` checks (knit_graph_checks.h), and a graph that
/// outlives the walk.
class RowWalk {
 public:
  explicit RowWalk(const KnitGraph& graph);

  RowPlace place(int node) const { return places_[node]; }
  /// The node after (before) this one in yarn order; wraps round in closed rows; -1 at a short
  /// row's end.
  int next(int node) const { return step(node, 1); }
  int previous(int node) const { return step(node, -1); }
  /// Column-wise successors and predecessors, in the order of their row. Two that are
  /// neighbours across the place where a closed row's list begins again stand in yarn order
  /// too: last node, then first.
  const std::vector<int>& above(int node) const { return above_[node]; }
  const std::vector<int>& below(int node) const { return below_[node]; }
  /// True for the first and the last node of a short row.
  bool is_row_end(int node) const { return next(node) < 0 || previous(node) < 0; }

 private:
  int step(int node, int by) const;

  const KnitGraph& graph_;
  std::vector<RowPlace> places_;
  std::vector<std::vector<int>> above_, below_;
};

}  // namespace meshknit
