#include "meshknit/tracing/tubes.h"

#include "meshknit/knit_graph/closed_row_links.h"

namespace meshknit {

Tubes find_tubes(const KnitGraph& graph) {
  const ClosedRowLinks links = link_closed_rows(graph, RowWalk(graph));
  Tubes tubes;
  tubes.of_row.assign(graph.rows.size(), -1);
  for (int row = 0; row < static_cast<int>(graph.rows.size()); ++row) {
    const std::vector<int>& below = links.below[row];
    const bool goes_on =
        below.size() == 1 && (!graph.rows[row].closed || !links.is_split(below.front()));
    tubes.of_row[row] = goes_on ? tubes.of_row[below.front()] : tubes.count++;
  }
  return tubes;
}

}  // namespace meshknit
