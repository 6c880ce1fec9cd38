#include "meshknit/remesh/finish_graph.h"

#include <algorithm>

#include "meshknit/remesh/section_length.h"

namespace meshknit {

void finish_graph(const TriangleMesh& mesh, const std::vector<int>& faces, KnitGraph& graph) {
  const auto length = [&](int a, int b) {
    return section_length(mesh, {faces[a], graph.nodes[a].position},
                          {faces[b], graph.nodes[b].position});
  };
  // Columns of one node were found in row order: a stable sort keeps that.
  std::stable_sort(graph.columns.begin(), graph.columns.end(),
                   [](const auto& a, const auto& b) { return a[0] < b[0]; });
  graph.column_lengths.clear();
  for (const auto& column : graph.columns)
    graph.column_lengths.push_back(length(column[0], column[1]));
  graph.row_lengths.clear();
  for (const KnitRow& row : graph.rows) {
    const std::size_t n = row.nodes.size();
    std::vector<double> lengths;
    for (std::size_t i = 0; i + 1 < n + row.closed; ++i)
      lengths.push_back(length(row.nodes[i], row.nodes[(i + 1) % n]));
    graph.row_lengths.push_back(std::move(lengths));
  }
}

}  // namespace meshknit
