#pragma once

#include <array>
#include <vector>

#include "meshknit/knit_graph/knit_graph.h"

namespace meshknit {

/// Where a node sits in its row.
struct RowPlace {
  int row = -1;
  int index = -1;
};

/// Neighbours in a knit graph, ready to walk. -1 stands for "none".
/// Requires the shape that `check_graph_form` checks (knit_graph_checks.h).
class RowWalk {
 public:
  explicit RowWalk(const KnitGraph& graph);

  RowPlace place(int node) const { return places_[node]; }
  /// The node after (before) this one in yarn order; wraps round in closed rows; -1 at a short row's end.
  int next(int node) const;
  int previous(int node) const;
  /// Column-wise successors and predecessors, in the order of their row.
  const std::vector<int>& above(int node) const { return above_[node]; }
  const std::vector<int>& below(int node) const { return below_[node]; }

 private:
  const KnitGraph& graph_;
  std::vector<RowPlace> places_;
  std::vector<std::vector<int>> above_, below_;
};

}  // namespace meshknit
