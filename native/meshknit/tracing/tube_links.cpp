#include "meshknit/tracing/tube_links.h"

#include <algorithm>

#include "meshknit/knit_graph/ring_parts.h"
#include "meshknit/knit_graph/rows.h"

namespace meshknit {
namespace {

double time_of(const KnitGraph& graph, const KnitRow& row) {
  double sum = 0.0;
  for (const int node : row.nodes) sum += graph.nodes[node].time;
  return sum / static_cast<double>(row.nodes.size());
}

std::vector<TubeLinks> link_in_order(const KnitGraph& graph, const Tubes& tubes) {
  std::vector<TubeLinks> links(tubes.count);
  std::vector<bool> begun(tubes.count, false);
  const RowWalk walk(graph);
  for (std::size_t row = 0; row < graph.rows.size(); ++row) {
    const int tube = tubes.of_row[row];
    TubeLinks& own = links[tube];
    const double time = time_of(graph, graph.rows[row]);
    own.begin = begun[tube] ? std::min(own.begin, time) : time;
    own.end = begun[tube] ? std::max(own.end, time) : time;
    begun[tube] = true;
    for (const int node : graph.rows[row].nodes)
      for (const int below : walk.below(node)) {
        const int other = tubes.of_row[walk.place(below).row];
        if (other == tube || std::count(own.below.begin(), own.below.end(), other) > 0)
          continue;
        own.below.push_back(other);
        links[other].above.push_back(tube);
      }
  }
  return links;
}

// Puts tubes that part from a closed row, or meet in it, into the order in which they hang.
void put_side_by_side(const KnitGraph& graph, const Tubes& tubes,
                      std::vector<TubeLinks>& links) {
  const RowWalk walk(graph);
  for (std::size_t row = 0; row < graph.rows.size(); ++row) {
    if (!graph.rows[row].closed) continue;
    TubeLinks& own = links[tubes.of_row[row]];
    for (const bool up : {false, true}) {
      std::vector<int>& others = up ? own.above : own.below;
      std::vector<int> part;
      for (const int node : graph.rows[row].nodes)
        for (const int other : up ? walk.above(node) : walk.below(node)) {
          const int tube = tubes.of_row[walk.place(other).row];
          if (tube != tubes.of_row[row]) part.push_back(tube);
        }
      if (others.size() < 3 || part.empty()) continue;
      const std::vector<PartStretch> stretches = ring_parts(part);
      if (stretches.size() != 2 * (others.size() - 1)) continue;
      for (std::size_t k = 0; k < others.size(); ++k) others[k] = stretches[k].part;
    }
  }
}

}  // namespace

std::vector<TubeLinks> link_tubes(const KnitGraph& graph, const Tubes& tubes) {
  std::vector<TubeLinks> links = link_in_order(graph, tubes);
  put_side_by_side(graph, tubes, links);
  return links;
}

}  // namespace meshknit
