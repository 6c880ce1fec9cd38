#pragma once

#include <vector>

#include "meshknit/knit_graph/knit_graph.h"

namespace meshknit {

/// The generalized cylinders of a graph (paper, sections 2.2 and 3.3): a tube is a stack of closed
/// rows from a start, split or merge up to the next split, merge or end, with the short rows that
/// stand on them.
struct Tubes {
  std::vector<int> of_row;  ///< [row]: its tube, numbered by their lowest rows
  int count = 0;
};

/// Requires: check_graph_form and check_helix_free find nothing.
Tubes find_tubes(const KnitGraph& graph);

}  // namespace meshknit
