// Property 5: splits and merges happen between whole rows, one loop to one loop.

#include <string>
#include <utility>

#include "meshknit/knit_graph/closed_row_links.h"
#include "meshknit/knit_graph/knit_graph_checks.h"
#include "meshknit/knit_graph/node_problem.h"

namespace meshknit {
namespace {

/// The side of a branching row on which it branches.
enum class Branching { split, merge };

class SplitCheck {
 public:
  explicit SplitCheck(const KnitGraph& graph)
      : graph_(graph), walk_(graph), links_(link_closed_rows(graph, walk_)) {}

  Problems find() {
    for (int row = 0; row < static_cast<int>(graph_.rows.size()); ++row) {
      if (links_.is_split(row)) check_branching(row, Branching::split);
      if (!links_.is_merge(row)) continue;
      if (graph_.rows[row].closed) {
        check_branching(row, Branching::merge);
      } else {
        problems_.push_back(
            node_problem("property-5-short-row-at-merge",
                         "Short row " + std::to_string(row) +
                             " lies across a merge; tubes must merge in a whole row.",
                         kMendGraph, graph_.rows[row].nodes));
      }
    }
    return std::move(problems_);
  }

 private:
  void check_branching(int row, Branching branching) {
    const bool split = branching == Branching::split;
    const std::string word = split ? "split" : "merge";
    for (const int node : graph_.rows[row].nodes) {
      const std::vector<int>& others = split ? walk_.above(node) : walk_.below(node);
      for (const int other : others) {
        if (!graph_.rows[walk_.place(other).row].closed)
          problems_.push_back(node_problem("property-5-short-row-at-" + word,
                                           "A short row lies at the " + word + " of row " +
                                               std::to_string(row) + "; tubes must " + word +
                                               " in a whole row.",
                                           kMendGraph, {node, other}));
        const std::size_t back = (split ? walk_.below(other) : walk_.above(other)).size();
        if (others.size() != 1 || back != 1)
          problems_.push_back(node_problem(
              "property-5-shaping-at-" + word,
              "Loops at the " + word + " of row " + std::to_string(row) +
                  " must go over one to one; those of nodes " + std::to_string(node) + " and " +
                  std::to_string(other) + " do not.",
              kMendGraph, {node, other}));
      }
    }
  }

  const KnitGraph& graph_;
  RowWalk walk_;
  ClosedRowLinks links_;
  Problems problems_;
};

}  // namespace

Problems check_simple_splits(const KnitGraph& graph) { return SplitCheck(graph).find(); }

}  // namespace meshknit
