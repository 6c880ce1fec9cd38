#include "meshknit/knit_graph/knit_graph_checks.h"

namespace meshknit {

KnitGraphCheck check_knit_graph(const KnitGraph& graph) {
  KnitGraphCheck check;
  check.problems = check_graph_form(graph);
  if (!check.problems.empty()) return check;

  const auto add = [&](std::size_t property, const Problems& found) {
    for (const Problem& problem : found)
      if (problem.severity == Severity::error) ++check.violations[property - 1];
    check.problems.insert(check.problems.end(), found.begin(), found.end());
  };
  add(1, check_consistent_orientation(graph));
  add(2, check_helix_free(graph));
  add(3, check_node_degree(graph));
  add(4, check_simple_short_rows(graph));
  // What branches and what stays one tube is only known once the rows have an order.
  if (check.violations[1] == 0) add(5, check_simple_splits(graph));
  if (check.violations[1] == 0 && check.violations[4] == 0)
    add(6, check_feasible_splits(graph));
  const Problems warnings = check_time_aligned(graph);
  check.problems.insert(check.problems.end(), warnings.begin(), warnings.end());
  return check;
}

}  // namespace meshknit
