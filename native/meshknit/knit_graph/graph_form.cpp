#include <cmath>
#include <string>
#include <utility>

#include "meshknit/knit_graph/knit_graph_checks.h"
#include "meshknit/knit_graph/node_problem.h"
#include "meshknit/knit_graph/rows.h"

namespace meshknit {
namespace {

const char* const kRemedy = "Build the graph again; if it comes from a file, correct it there.";

Problem form_problem(const std::string& code, const std::string& message,
                     std::vector<int> nodes = {}) {
  return node_problem(code, message, kRemedy, std::move(nodes));
}

bool is_length(double length) { return std::isfinite(length) && length > 0.0; }

std::string row_name(int row) { return "Row " + std::to_string(row); }

Problems check_rows(const KnitGraph& graph) {
  Problems problems;
  const int count = static_cast<int>(graph.nodes.size());
  std::vector<int> times_listed(count, 0);
  for (int r = 0; r < static_cast<int>(graph.rows.size()); ++r) {
    const KnitRow& row = graph.rows[r];
    const std::size_t fewest = row.closed ? 3 : 1;
    if (row.nodes.size() < fewest)
      problems.push_back(form_problem(
          "row-too-short",
          row_name(r) + " has fewer nodes than a row needs (" + std::to_string(fewest) + ").",
          row.nodes));
    for (const int node : row.nodes) {
      if (node < 0 || node >= count) {
        problems.push_back(form_problem(
            "node-out-of-range",
            row_name(r) + " names node " + std::to_string(node) + ", which is not there."));
      } else {
        ++times_listed[node];
      }
    }
  }
  for (int node = 0; node < count; ++node)
    if (times_listed[node] != 1)
      problems.push_back(form_problem("node-not-in-one-row",
                                      "Node " + std::to_string(node) + " is in " +
                                          std::to_string(times_listed[node]) +
                                          " rows instead of one.",
                                      {node}));
  return problems;
}

Problems check_column_ends(const KnitGraph& graph) {
  Problems problems;
  const int count = static_cast<int>(graph.nodes.size());
  for (const auto& [from, to] : graph.columns)
    if (from < 0 || from >= count || to < 0 || to >= count)
      problems.push_back(form_problem(
          "column-out-of-range", "The column from node " + std::to_string(from) + " to node " +
                                     std::to_string(to) + " names a node that is not there."));
  return problems;
}

Problems check_column_order(const KnitGraph& graph) {
  Problems problems;
  const RowWalk walk(graph);
  std::size_t k = 0;
  for (int node = 0; node < static_cast<int>(graph.nodes.size()); ++node) {
    for (std::size_t i = 0; i < walk.above(node).size(); ++i, ++k) {
      const bool repeated = i > 0 && walk.above(node)[i] == walk.above(node)[i - 1];
      if (graph.columns[k][0] == node && graph.columns[k][1] == walk.above(node)[i] &&
          !repeated)
        continue;
      problems.push_back(
          form_problem("columns-out-of-order",
                       repeated ? "The columns of node " + std::to_string(node) +
                                      " name the same node above twice."
                                : "Columns must be ordered by their lower node, then along the "
                                  "upper row; from node " +
                                      std::to_string(node) + " on they are not.",
                       {node}));
      return problems;
    }
  }
  return problems;
}

Problems check_numbers(const KnitGraph& graph) {
  Problems problems;
  if (!is_length(graph.stitch_width) || !is_length(graph.stitch_height))
    problems.push_back(
        form_problem("bad-number", "Stitch width and height must be lengths above zero."));
  for (int i = 0; i < static_cast<int>(graph.nodes.size()); ++i)
    if (!graph.nodes[i].position.allFinite() || !std::isfinite(graph.nodes[i].time))
      problems.push_back(form_problem(
          "bad-number",
          "Node " + std::to_string(i) + " has a position or time that is not a number.", {i}));

  if (graph.row_lengths.size() != graph.rows.size() ||
      graph.column_lengths.size() != graph.columns.size()) {
    problems.push_back(
        form_problem("missing-length", "Every row and every column edge needs its length."));
    return problems;
  }
  for (int r = 0; r < static_cast<int>(graph.rows.size()); ++r) {
    const KnitRow& row = graph.rows[r];
    const std::size_t edges = row.nodes.size() - (row.closed || row.nodes.empty() ? 0 : 1);
    if (graph.row_lengths[r].size() != edges)
      problems.push_back(
          form_problem("missing-length",
                       row_name(r) + " has " + std::to_string(edges) + " edges but " +
                           std::to_string(graph.row_lengths[r].size()) + " lengths.",
                       row.nodes));
    for (const double length : graph.row_lengths[r])
      if (!is_length(length)) {
        problems.push_back(
            form_problem("bad-length",
                         row_name(r) + " has an edge without a length above zero.", row.nodes));
        break;
      }
  }
  for (std::size_t k = 0; k < graph.columns.size(); ++k)
    if (!is_length(graph.column_lengths[k]))
      problems.push_back(form_problem(
          "bad-length",
          "The column from node " + std::to_string(graph.columns[k][0]) + " to node " +
              std::to_string(graph.columns[k][1]) + " has no length above zero.",
          {graph.columns[k][0], graph.columns[k][1]}));
  return problems;
}

void append(Problems& problems, const Problems& more) {
  problems.insert(problems.end(), more.begin(), more.end());
}

}  // namespace

Problems check_graph_form(const KnitGraph& graph) {
  Problems problems = check_rows(graph);
  append(problems, check_column_ends(graph));
  // Neighbours can only be looked up once all indices are good.
  if (problems.empty()) append(problems, check_column_order(graph));
  append(problems, check_numbers(graph));
  return problems;
}

}  // namespace meshknit
