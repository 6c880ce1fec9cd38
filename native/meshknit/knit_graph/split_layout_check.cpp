// Property 6: the rows of every split and merge must find a layout together.

#include <string>

#include "meshknit/knit_graph/closed_row_links.h"
#include "meshknit/knit_graph/knit_graph_checks.h"
#include "meshknit/knit_graph/node_problem.h"
#include "meshknit/knit_graph/split_layout.h"

namespace meshknit {
namespace {

/// A row takes part in a branching with its upper loops (as a lower row) or with its lower
/// ones.
struct RowSide {
  int row = -1;
  bool lower = true;
};

/// All row sides that hang together with this split or merge.
std::vector<RowSide> rows_of_branching(const ClosedRowLinks& links, RowSide first,
                                       std::vector<bool>& seen_lower,
                                       std::vector<bool>& seen_upper) {
  std::vector<RowSide> sides;
  const auto visit = [&](RowSide side) {
    std::vector<bool>& seen = side.lower ? seen_lower : seen_upper;
    if (seen[side.row]) return;
    seen[side.row] = true;
    sides.push_back(side);
  };
  visit(first);
  for (std::size_t i = 0; i < sides.size(); ++i) {
    const RowSide side = sides[i];
    for (const int other : side.lower ? links.above[side.row] : links.below[side.row])
      visit({other, !side.lower});
  }
  return sides;
}

}  // namespace

Problems check_feasible_splits(const KnitGraph& graph) {
  const RowWalk walk(graph);
  const ClosedRowLinks links = link_closed_rows(graph, walk);
  const int rows = static_cast<int>(graph.rows.size());
  std::vector<bool> seen_lower(rows, false), seen_upper(rows, false);
  Problems problems;
  for (int row = 0; row < rows; ++row) {
    if (!graph.rows[row].closed) continue;
    for (const bool lower : {false, true}) {
      const bool branches = lower ? links.is_split(row) : links.is_merge(row);
      if (!branches || (lower ? seen_lower : seen_upper)[row]) continue;

      // By Property 5 every column is named by its lower node.
      std::vector<std::vector<int>> cycles;
      std::vector<int> nodes;
      for (const RowSide side :
           rows_of_branching(links, {row, lower}, seen_lower, seen_upper)) {
        std::vector<int> cycle = graph.rows[side.row].nodes;
        nodes.insert(nodes.end(), cycle.begin(), cycle.end());
        if (!side.lower)
          for (int& node : cycle) node = walk.below(node).front();
        cycles.push_back(std::move(cycle));
      }
      if (!has_common_layout(cycles))
        problems.push_back(node_problem(
            "property-6-no-layout",
            "Where row " + std::to_string(row) + (lower ? " splits" : " merges") +
                ", its loops cannot be divided between the beds without stretching yarn.",
            "Let the tubes part (or meet) in two steps at different times, or make them more "
            "equal there.",
            nodes));
    }
  }
  return problems;
}

}  // namespace meshknit
