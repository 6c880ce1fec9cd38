#include "meshknit/knit_graph/closed_row_links.h"

#include <algorithm>

namespace meshknit {

ClosedRowLinks link_closed_rows(const KnitGraph& graph, const RowWalk& walk) {
  const int rows = static_cast<int>(graph.rows.size());
  ClosedRowLinks links;
  links.above.resize(rows);
  links.below.resize(rows);
  for (int row = 0; row < rows; ++row) {
    std::vector<int> lower_rows;
    for (const int node : graph.rows[row].nodes)
      for (const int from : walk.below(node)) lower_rows.push_back(walk.place(from).row);
    std::sort(lower_rows.begin(), lower_rows.end());
    lower_rows.erase(std::unique(lower_rows.begin(), lower_rows.end()), lower_rows.end());

    std::vector<int>& below = links.below[row];
    for (const int lower : lower_rows) {
      if (graph.rows[lower].closed) {
        below.push_back(lower);
      } else {
        // Rows are listed in the order in which they are made: a lower row's list is complete.
        below.insert(below.end(), links.below[lower].begin(), links.below[lower].end());
      }
    }
    std::sort(below.begin(), below.end());
    below.erase(std::unique(below.begin(), below.end()), below.end());
    if (!graph.rows[row].closed) continue;
    for (const int lower : below) links.above[lower].push_back(row);
  }
  return links;
}

}  // namespace meshknit
