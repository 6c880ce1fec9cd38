#pragma once

#include <vector>

#include "meshknit/knit_graph/knit_graph.h"
#include "meshknit/remesh/acceptance.h"
#include "meshknit/remesh/active_cycle.h"
#include "meshknit/remesh/linking.h"
#include "meshknit/remesh/slicing.h"

namespace meshknit {

/// The next row before it is part of the graph.
struct NextRow {
  std::vector<double> place;  ///< along the next cycle
  std::vector<double> time;
  std::vector<char> single;
  std::vector<NodeRun> runs;  ///< empty: all accepted
  std::vector<Link> links;    ///< (active node, next node)
};

/// The knit graph while it grows, with the triangle that each node lies in.
class GraphBuilder {
 public:
  GraphBuilder(const PeelState& state, double stitch_width, double stitch_height);

  /// Adds the accepted nodes of a row and their row edges: one closed row, or a short row a run.
  /// Returns graph nodes, -1 for nodes that were not accepted.
  std::vector<int> add_rows(const NextCycle& next, const NextRow& row);
  void add_column(int from, int to) { graph_.columns.push_back({from, to}); }

  KnitGraph& graph() { return graph_; }
  std::vector<int>& faces() { return face_of_node_; }

 private:
  const PeelState& state_;
  KnitGraph graph_;
  std::vector<int> face_of_node_;
};

/// A node at a place of a cycle, ready to be linked from.
ActiveNode active_node(const NextCycle& next, double place, int node);

}  // namespace meshknit
