// Properties 7 and 8: how well the graph follows the time field and the stitch sizes.

#include <algorithm>
#include <cmath>

#include "meshknit/knit_graph/closed_row_links.h"
#include "meshknit/knit_graph/knit_graph_checks.h"
#include "meshknit/knit_graph/node_problem.h"

namespace meshknit {
namespace {

int histogram_bin(double signed_error) {
  // A perfect edge may be a rounding too short.
  const double rounding = 1e-12;
  int bin = 0;
  while (bin < histogram_bins - 1 && signed_error + rounding >= histogram_bound(bin)) ++bin;
  return bin;
}

LengthError measure_lengths(const std::vector<double>& lengths, double wanted) {
  LengthError error;
  error.edges = static_cast<int>(lengths.size());
  if (lengths.empty()) return error;
  std::vector<double> errors;
  errors.reserve(lengths.size());
  for (const double length : lengths) {
    errors.push_back(std::abs(length - wanted) / wanted);
    ++error.histogram[histogram_bin((length - wanted) / wanted)];
  }
  std::sort(errors.begin(), errors.end());

  const double count = static_cast<double>(errors.size());
  for (const double e : errors) error.mean += e / count;
  // The smallest error that at least 95 % of the edges do not exceed.
  const std::size_t rank = (errors.size() * 95 + 99) / 100;
  error.p95 = errors[rank - 1];
  const auto within = [&](double limit) {
    const double rounding = 1e-12;
    return static_cast<double>(
               std::upper_bound(errors.begin(), errors.end(), limit + rounding) -
               errors.begin()) /
           count;
  };
  error.within_10 = within(0.1);
  error.within_20 = within(0.2);
  return error;
}

void count_irregular_nodes(const KnitGraph& graph, KnitGraphStats& stats) {
  std::vector<int> up(graph.nodes.size(), 0), down(graph.nodes.size(), 0);
  std::vector<char> ends_row(graph.nodes.size(), 0);
  for (const auto& [from, to] : graph.columns) {
    ++up[from];
    ++down[to];
  }
  for (const KnitRow& row : graph.rows)
    if (!row.closed) ends_row[row.nodes.front()] = ends_row[row.nodes.back()] = 1;
  for (std::size_t node = 0; node < graph.nodes.size(); ++node) {
    stats.increases += up[node] == 2;
    stats.decreases += down[node] == 2;
    stats.short_row_ends += ends_row[node];
    stats.irregular += up[node] == 2 || down[node] == 2 || ends_row[node];
  }
}

}  // namespace

Problems check_time_aligned(const KnitGraph& graph) {
  Problems problems;
  const char* const remedy = "Move the time constraints apart there, or add one in between.";
  std::vector<int> falling;
  double climb = 0.0;
  for (const auto& [from, to] : graph.columns) {
    const double step = graph.nodes[to].time - graph.nodes[from].time;
    climb += step / static_cast<double>(graph.columns.size());
    if (step <= 0.0) falling.insert(falling.end(), {from, to});
  }
  if (!falling.empty())
    problems.push_back(node_problem("property-7-falling-column",
                                    "Some columns do not go on to a later knitting time.",
                                    remedy, falling, Severity::warning));

  // A row edge is about as long as a column edge is high: one that gains more time than an
  // average column edge climbs steeper than 45 degrees.
  std::vector<int> steep;
  for (const KnitRow& row : graph.rows) {
    const std::size_t edges = row.nodes.size() - (row.closed ? 0 : 1);
    for (std::size_t i = 0; i < edges; ++i) {
      const int a = row.nodes[i], b = row.nodes[(i + 1) % row.nodes.size()];
      if (climb > 0.0 && std::abs(graph.nodes[b].time - graph.nodes[a].time) > climb)
        steep.insert(steep.end(), {a, b});
    }
  }
  if (!steep.empty())
    problems.push_back(node_problem(
        "property-7-steep-row", "Some rows run across the knitting time instead of along it.",
        remedy, steep, Severity::warning));
  return problems;
}

KnitGraphStats measure_graph(const KnitGraph& graph) {
  KnitGraphStats stats;
  stats.nodes = static_cast<int>(graph.nodes.size());
  stats.rows = static_cast<int>(graph.rows.size());
  const RowWalk walk(graph);
  const ClosedRowLinks links = link_closed_rows(graph, walk);
  std::vector<double> row_lengths;
  for (int row = 0; row < stats.rows; ++row) {
    if (!graph.rows[row].closed) ++stats.short_rows;
    const int above = static_cast<int>(links.above[row].size());
    const int below = static_cast<int>(links.below[row].size());
    if (above > 1) stats.splits += above - 1;
    if (graph.rows[row].closed && below > 1) stats.merges += below - 1;
    row_lengths.insert(row_lengths.end(), graph.row_lengths[row].begin(),
                       graph.row_lengths[row].end());
  }
  count_irregular_nodes(graph, stats);
  stats.row_error = measure_lengths(row_lengths, graph.stitch_width);
  stats.column_error = measure_lengths(graph.column_lengths, 2.0 * graph.stitch_height);
  return stats;
}

}  // namespace meshknit
