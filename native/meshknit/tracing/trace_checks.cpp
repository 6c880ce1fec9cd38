#include "meshknit/tracing/trace_checks.h"

#include "meshknit/tracing/trace_promises.h"

namespace meshknit {

Problems check_trace(const KnitGraph& graph, const StitchTrace& trace) {
  // Every group can only be asked of a trace that keeps the promises before it.
  Problems problems = check_stitch_indices(graph, trace);
  if (!problems.empty()) return problems;

  const auto add = [&](const Problems& more) {
    problems.insert(problems.end(), more.begin(), more.end());
  };
  add(check_families(trace));
  add(check_kinds(trace));
  add(check_nodes_knit_twice(graph, trace));
  if (!problems.empty()) return problems;

  add(check_tubes(graph, trace));
  add(check_loops_follow_columns(graph, trace));
  if (problems.empty()) add(check_yarn_path(graph, trace));
  add(check_yarn_count(graph, trace));
  return problems;
}

}  // namespace meshknit
