// Properties 1, 3 and 4: what one row and its columns look like from close by.

#include <string>

#include "meshknit/knit_graph/knit_graph_checks.h"
#include "meshknit/knit_graph/node_problem.h"
#include "meshknit/knit_graph/rows.h"

namespace meshknit {
namespace {

std::string name(int node) { return "node " + std::to_string(node); }

std::string name_both(int a, int b) { return name(a) + " and " + name(b); }

/// True if the nodes above b go on where the nodes above a stop. In rows of three or four nodes
/// the far ends of two increases meet again round the row; that alone is no reversal.
bool goes_on(const RowWalk& walk, const std::vector<int>& above_a,
             const std::vector<int>& above_b) {
  return above_a.back() == above_b.front() || walk.next(above_a.back()) == above_b.front();
}

/// Violations of "all nodes of a row have columns on this side, or none has".
void find_loose_nodes(const KnitGraph& graph, const RowWalk& walk, bool upward,
                      Problems& problems) {
  for (const KnitRow& row : graph.rows) {
    std::vector<int> loose;
    for (const int node : row.nodes)
      if ((upward ? walk.above(node) : walk.below(node)).empty()) loose.push_back(node);
    if (loose.empty() || loose.size() == row.nodes.size()) continue;
    const std::string message =
        upward ? "The loops of some nodes are never knit through although their row goes on."
               : "Some nodes begin in the middle of a row without a loop to knit through.";
    problems.push_back(node_problem("property-3-loose-node", message, kMendGraph, loose));
  }
}

}  // namespace

Problems check_consistent_orientation(const KnitGraph& graph) {
  const RowWalk walk(graph);
  Problems problems;
  for (int a = 0; a < static_cast<int>(graph.nodes.size()); ++a) {
    const int b = walk.next(a);
    if (b < 0 || walk.above(a).empty() || walk.above(b).empty()) continue;
    if (goes_on(walk, walk.above(a), walk.above(b))) continue;
    for (const int c : walk.above(a))
      for (const int d : walk.above(b))
        if (walk.next(d) == c)
          problems.push_back(node_problem("property-1-reversed-row",
                                          "The row with " + name_both(d, c) +
                                              " runs against the row below it, which has " +
                                              name_both(a, b) + ".",
                                          kMendGraph, {a, b, c, d}));
  }
  return problems;
}

Problems check_node_degree(const KnitGraph& graph) {
  const RowWalk walk(graph);
  Problems problems;
  for (int node = 0; node < static_cast<int>(graph.nodes.size()); ++node) {
    const std::size_t up = walk.above(node).size(), down = walk.below(node).size();
    if (up > 2)
      problems.push_back(node_problem("property-3-too-many-above",
                                      "A stitch makes at most two loops, but " + name(node) +
                                          " has " + std::to_string(up) + " columns up.",
                                      kMendGraph, {node}));
    if (down > 2)
      problems.push_back(node_problem("property-3-too-many-below",
                                      "A stitch joins at most two loops, but " + name(node) +
                                          " has " + std::to_string(down) + " columns down.",
                                      kMendGraph, {node}));
  }
  find_loose_nodes(graph, walk, true, problems);
  find_loose_nodes(graph, walk, false, problems);
  return problems;
}

Problems check_simple_short_rows(const KnitGraph& graph) {
  const RowWalk walk(graph);
  Problems problems;
  for (int node = 0; node < static_cast<int>(graph.nodes.size()); ++node) {
    const std::vector<int>&above = walk.above(node), &below = walk.below(node);
    if (walk.is_row_end(node) && (above.size() != 1 || below.size() != 1))
      problems.push_back(
          node_problem("property-4-row-end",
                       "The end of a short row needs exactly one column up and one down; " +
                           name(node) + " has " + std::to_string(above.size()) + " and " +
                           std::to_string(below.size()) + ".",
                       kMendGraph, {node}));
    if (above.size() == 2 && walk.next(above[0]) != above[1])
      problems.push_back(node_problem("property-4-shaping-across-rows",
                                      "The increase at " + name(node) + " leads to " +
                                          name_both(above[0], above[1]) +
                                          ", which are not neighbours in one row.",
                                      kMendGraph, {node, above[0], above[1]}));
    if (below.size() == 2 && walk.next(below[0]) != below[1])
      problems.push_back(node_problem("property-4-shaping-across-rows",
                                      "The decrease at " + name(node) + " joins " +
                                          name_both(below[0], below[1]) +
                                          ", which are not neighbours in one row.",
                                      kMendGraph, {node, below[0], below[1]}));
  }
  return problems;
}

}  // namespace meshknit
