#pragma once

#include <vector>

#include "meshknit/knit_graph/knit_graph.h"
#include "meshknit/knit_graph/rows.h"

namespace meshknit {

/// Which closed rows follow each other when the short rows between them are left out.
///
/// A short row is knit together with the closed row that it stands on, directly or on top of
/// other short rows (paper, section 3.3, figure 13), so it counts as part of that row. With
/// that, closed rows form the arcs and branches of the paper's generalized cylinders: a row
/// with two or more closed rows above it is a split, one with two or more below it a merge, and
/// everything else is a stack of rows of one tube.
struct ClosedRowLinks {
  std::vector<std::vector<int>> above;  ///< [row]: closed rows next above; empty for short rows
  std::vector<std::vector<int>>
      below;  ///< [row]: closed rows that it stands on; also for short rows

  bool is_split(int row) const { return above[row].size() > 1; }
  bool is_merge(int row) const { return below[row].size() > 1; }
};

/// Requires: check_graph_form and check_helix_free find nothing. Lists are ascending.
ClosedRowLinks link_closed_rows(const KnitGraph& graph, const RowWalk& walk);

}  // namespace meshknit
