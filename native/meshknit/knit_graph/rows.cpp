#include "meshknit/knit_graph/rows.h"

#include <algorithm>

namespace meshknit {

RowWalk::RowWalk(const KnitGraph& graph)
    : graph_(graph),
      places_(graph.nodes.size()),
      above_(graph.nodes.size()),
      below_(graph.nodes.size()) {
  for (int r = 0; r < static_cast<int>(graph.rows.size()); ++r) {
    const std::vector<int>& nodes = graph.rows[r].nodes;
    for (int i = 0; i < static_cast<int>(nodes.size()); ++i) places_[nodes[i]] = {r, i};
  }
  for (const auto& [from, to] : graph.columns) {
    above_[from].push_back(to);
    below_[to].push_back(from);
  }

  const auto earlier = [this](int a, int b) {
    const RowPlace p = places_[a], q = places_[b];
    return p.row != q.row ? p.row < q.row : p.index < q.index;
  };
  const auto put_in_row_order = [&](std::vector<int>& nodes) {
    std::sort(nodes.begin(), nodes.end(), earlier);
    // By index the pair (first, last) of a closed row stands the wrong way round.
    if (nodes.size() == 2 && next(nodes[1]) == nodes[0] && next(nodes[0]) != nodes[1])
      std::swap(nodes[0], nodes[1]);
  };
  for (std::vector<int>& nodes : above_) put_in_row_order(nodes);
  for (std::vector<int>& nodes : below_) put_in_row_order(nodes);
}

int RowWalk::step(int node, int by) const {
  const auto [row, index] = places_[node];
  const std::vector<int>& nodes = graph_.rows[row].nodes;
  const int size = static_cast<int>(nodes.size());
  const int target = index + by;
  if (target >= 0 && target < size) return nodes[target];
  return graph_.rows[row].closed ? nodes[(target + size) % size] : -1;
}

}  // namespace meshknit
