// Promises that a trace keeps towards its graph, apart from the yarn's way.

#include <algorithm>
#include <string>

#include "meshknit/knit_graph/closed_row_links.h"
#include "meshknit/tracing/knit_twice.h"
#include "meshknit/tracing/trace_promises.h"
#include "meshknit/tracing/tubes.h"

namespace meshknit {
namespace {

/// Nodes of one row as a direction of travel meets them.
std::vector<int> in_direction(std::vector<int> nodes, Direction direction) {
  if (direction == Direction::clockwise) std::reverse(nodes.begin(), nodes.end());
  return nodes;
}

}  // namespace

Problems check_nodes_knit_twice(const KnitGraph& graph, const StitchTrace& trace) {
  Problems problems;
  std::vector<std::vector<int>> stitches(graph.nodes.size());
  for (int s = 0; s < static_cast<int>(trace.stitches.size()); ++s)
    if (trace.stitches[s].kind != StitchKind::tuck)
      stitches[trace.stitches[s].node].push_back(s);
  for (int node = 0; node < static_cast<int>(graph.nodes.size()); ++node) {
    if (stitches[node].size() == 2) continue;
    Problem problem =
        stitch_problem(trace, "node-not-knit-twice",
                       "Node " + std::to_string(node) + " is knit " +
                           std::to_string(stitches[node].size()) + " times instead of twice.",
                       stitches[node]);
    problem.elements.nodes = {node};
    problems.push_back(problem);
  }
  const int courses = 2 * static_cast<int>(graph.rows.size());
  if (trace.courses != courses)
    problems.push_back(stitch_problem(trace, "wrong-courses",
                                      "The trace counts " + std::to_string(trace.courses) +
                                          " courses; its graph has " + std::to_string(courses) +
                                          ".",
                                      {}));
  return problems;
}

Problems check_tubes(const KnitGraph& graph, const StitchTrace& trace) {
  const RowWalk walk(graph);
  const Tubes tubes = find_tubes(graph);
  Problems problems;
  int yarn_tube = 0;
  for (int s = 0; s < static_cast<int>(trace.stitches.size()); ++s) {
    const Stitch& stitch = trace.stitches[s];
    // A tuck may lie on a loop of the tube below; it belongs to the stitch before it.
    if (stitch.kind != StitchKind::tuck) yarn_tube = tubes.of_row[walk.place(stitch.node).row];
    if (stitch.tube != yarn_tube)
      problems.push_back(stitch_problem(
          trace, "wrong-tube",
          "Stitch " + std::to_string(s) + " does not belong to the tube of its row.", {s}));
  }
  if (trace.tubes != tubes.count)
    problems.push_back(stitch_problem(trace, "wrong-tube",
                                      "The trace counts " + std::to_string(trace.tubes) +
                                          " tubes; its graph has " +
                                          std::to_string(tubes.count) + ".",
                                      {}));
  return problems;
}

Problems check_loops_follow_columns(const KnitGraph& graph, const StitchTrace& trace) {
  const RowWalk walk(graph);
  const KnitTwice knit = find_stitches(graph, trace);
  Problems problems;
  const auto compare = [&](int s, const std::vector<int>& is, const std::vector<int>& wanted) {
    if (is == wanted) return;
    std::vector<int> stitches{s};
    stitches.insert(stitches.end(), is.begin(), is.end());
    problems.push_back(stitch_problem(
        trace, "loops-off-columns",
        "The loops of stitch " + std::to_string(s) + " do not follow the columns of node " +
            std::to_string(trace.stitches[s].node) + " in loop order.",
        stitches));
  };
  for (int node = 0; node < static_cast<int>(graph.nodes.size()); ++node) {
    const int first = knit.first[node], second = knit.second[node];
    std::vector<int> below, above;
    for (const int n : in_direction(walk.below(node), trace.stitches[first].direction))
      below.push_back(knit.second[n]);
    for (const int n : in_direction(walk.above(node), trace.stitches[second].direction))
      above.push_back(knit.first[n]);
    compare(first, loop_parents(trace, first), below);
    compare(first, trace.stitches[first].children, {second});
    compare(second, loop_parents(trace, second), {first});
    compare(second, trace.stitches[second].children, above);
  }
  return problems;
}

Problems check_yarn_count(const KnitGraph& graph, const StitchTrace& trace) {
  const RowWalk walk(graph);
  const ClosedRowLinks links = link_closed_rows(graph, walk);
  int allowed = 0;
  for (int row = 0; row < static_cast<int>(graph.rows.size()); ++row) {
    if (links.below[row].empty()) ++allowed;
    if (links.is_split(row)) allowed += static_cast<int>(links.above[row].size()) - 1;
  }
  if (trace.yarns <= allowed) return {};
  return {stitch_problem(trace, "too-many-yarns",
                         "The trace uses " + std::to_string(trace.yarns) +
                             " yarns; its graph needs " + std::to_string(allowed) + ".",
                         {})};
}

}  // namespace meshknit
