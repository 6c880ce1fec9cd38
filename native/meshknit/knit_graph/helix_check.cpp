// Property 2: contract every row to a point; then the columns must form a partial order.

#include <algorithm>
#include <queue>
#include <string>

#include "meshknit/knit_graph/knit_graph_checks.h"
#include "meshknit/knit_graph/node_problem.h"
#include "meshknit/knit_graph/rows.h"

namespace meshknit {
namespace {

/// Rows whose lower rows are all done are done, again and again (Kahn's topological sort).
class RowOrder {
 public:
  RowOrder(const KnitGraph& graph, const RowWalk& walk)
      : graph_(graph), walk_(walk), waiting_(graph.rows.size(), 0), done_(graph.rows.size()) {
    for (const auto& column : graph.columns) ++waiting_[walk.place(column[1]).row];
    for (int row = 0; row < rows(); ++row)
      if (waiting_[row] == 0 && !done_[row]) finish(row);
  }

  /// One cycle among the rows that are left, lowest first; empty if all are done.
  std::vector<int> find_cycle() const {
    int row = 0;
    while (row < rows() && done_[row]) ++row;
    if (row == rows()) return {};
    // Every row that is left has a lower row that is left: going down must come back.
    std::vector<int> path, place_in_path(rows(), -1);
    while (place_in_path[row] < 0) {
      place_in_path[row] = static_cast<int>(path.size());
      path.push_back(row);
      row = lowest_unfinished_below(row);
    }
    std::vector<int> cycle(path.begin() + place_in_path[row], path.end());
    std::sort(cycle.begin(), cycle.end());
    return cycle;
  }

  void finish(int first) {
    std::queue<int> ready;
    done_[first] = true;
    for (ready.push(first); !ready.empty(); ready.pop())
      for (const int node : graph_.rows[ready.front()].nodes)
        for (const int above : walk_.above(node)) {
          const int row = walk_.place(above).row;
          if (--waiting_[row] == 0 && !done_[row]) {
            done_[row] = true;
            ready.push(row);
          }
        }
  }

  bool is_done(int row) const { return done_[row]; }

 private:
  int rows() const { return static_cast<int>(graph_.rows.size()); }

  int lowest_unfinished_below(int row) const {
    int lowest = rows();
    for (const int node : graph_.rows[row].nodes)
      for (const int below : walk_.below(node))
        if (!done_[walk_.place(below).row]) lowest = std::min(lowest, walk_.place(below).row);
    return lowest;
  }

  const KnitGraph& graph_;
  const RowWalk& walk_;
  std::vector<int> waiting_;  ///< columns from rows that are not done
  std::vector<bool> done_;
};

}  // namespace

Problems check_helix_free(const KnitGraph& graph) {
  const RowWalk walk(graph);
  Problems problems;
  RowOrder order(graph, walk);
  for (std::vector<int> cycle = order.find_cycle(); !cycle.empty();
       cycle = order.find_cycle()) {
    std::vector<int> nodes;
    std::string names;
    for (const int row : cycle) {
      nodes.insert(nodes.end(), graph.rows[row].nodes.begin(), graph.rows[row].nodes.end());
      names += (names.empty() ? "" : ", ") + std::to_string(row);
    }
    problems.push_back(node_problem(
        "property-2-helix",
        "Going up from row to row leads back to where it began (rows " + names + "): a helix.",
        kMendGraph, nodes));
    // Take the cycle as done, to find further ones.
    for (const int row : cycle)
      if (!order.is_done(row)) order.finish(row);
  }
  if (!problems.empty()) return problems;

  for (const auto& [from, to] : graph.columns) {
    const int lower = walk.place(from).row, upper = walk.place(to).row;
    if (lower < upper) continue;
    problems.push_back(node_problem("property-2-row-order",
                                    "Row " + std::to_string(upper) + " stands on row " +
                                        std::to_string(lower) + " but is listed before it.",
                                    "List every row after the rows that it stands on.",
                                    {from, to}));
  }
  return problems;
}

}  // namespace meshknit
