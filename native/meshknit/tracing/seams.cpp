#include "meshknit/tracing/seams.h"

#include <algorithm>
#include <cstdlib>
#include <set>
#include <tuple>

#include "meshknit/knit_graph/rows.h"
#include "meshknit/tracing/seam_choice.h"
#include "meshknit/tracing/tube_links.h"
#include "meshknit/tracing/tubes.h"

namespace meshknit {
namespace {

// A row of a tube and the one above it, if nothing but columns lies between them.
struct Gap {
  int below = -1, above = -1;
};

// The one closed row that takes over all of this row's loops and no others; -1 if there is none.
int row_right_above(const KnitGraph& graph, const RowWalk& walk, int row) {
  const std::vector<int>& first = walk.above(graph.rows[row].nodes.front());
  if (first.empty()) return -1;
  const int above = walk.place(first.front()).row;
  if (!graph.rows[above].closed) return -1;
  for (const int node : graph.rows[row].nodes)
    for (const int other : walk.above(node))
      if (walk.place(other).row != above) return -1;
  for (const int node : graph.rows[above].nodes)
    for (const int other : walk.below(node))
      if (walk.place(other).row != row) return -1;
  return above;
}

class SeamPlaces {
 public:
  explicit SeamPlaces(const KnitGraph& graph)
      : graph_(graph), walk_(graph), tubes_(find_tubes(graph)), best_(tubes_.count) {
    std::vector<std::vector<int>> closed_rows(tubes_.count);
    for (int row = 0; row < static_cast<int>(graph.rows.size()); ++row)
      if (graph.rows[row].closed) closed_rows[tubes_.of_row[row]].push_back(row);
    for (int tube = 0; tube < tubes_.count; ++tube) choose(tube, closed_rows[tube]);
  }

  SeamPlan plan() const {
    std::vector<int> stitches;
    for (const Gap& gap : best_) stitches.push_back(gap.below < 0 ? 0 : nodes_at(gap));
    const SeamChoice choice = choose_seams(link_tubes(graph_, tubes_), stitches);
    SeamPlan plan;
    plan.needed = choice.needed;
    for (const int tube : choice.tubes) plan.seams.push_back(seam_at(best_[tube]));
    std::sort(plan.seams.begin(), plan.seams.end(),
              [](const Seam& a, const Seam& b) { return a.row_above < b.row_above; });
    return plan;
  }

 private:
  int size_of(int row) const { return static_cast<int>(graph_.rows[row].nodes.size()); }
  int nodes_at(const Gap& gap) const { return size_of(gap.below) + size_of(gap.above); }

  int shaped_at(const Gap& gap) const {
    int shaped = 0;
    for (const int node : graph_.rows[gap.below].nodes) shaped += walk_.above(node).size() > 1;
    for (const int node : graph_.rows[gap.above].nodes) shaped += walk_.below(node).size() > 1;
    return shaped;
  }

  // Rows of a tube are listed upwards.
  void choose(int tube, const std::vector<int>& rows) {
    std::tuple<int, int, int> least;
    for (int i = 0; i + 1 < static_cast<int>(rows.size()); ++i) {
      if (row_right_above(graph_, walk_, rows[i]) != rows[i + 1]) continue;
      const Gap gap{rows[i], rows[i + 1]};
      const int from_middle = std::abs(2 * i + 2 - static_cast<int>(rows.size()));
      const std::tuple<int, int, int> cost{nodes_at(gap), shaped_at(gap), from_middle};
      if (best_[tube].below >= 0 && !(cost < least)) continue;
      best_[tube] = gap;
      least = cost;
    }
  }

  Seam seam_at(const Gap& gap) const {
    Seam seam;
    seam.row_below = gap.below;
    seam.row_above = gap.above;
    for (const auto& column : graph_.columns)
      if (walk_.place(column[0]).row == gap.below) seam.columns.push_back(column);
    for (const int row : {gap.below, gap.above})
      for (const int node : graph_.rows[row].nodes)
        seam.middle += graph_.nodes[node].position / nodes_at(gap);
    return seam;
  }

  const KnitGraph& graph_;
  RowWalk walk_;
  Tubes tubes_;
  std::vector<Gap> best_;  // [tube]
};

}  // namespace

SeamPlan plan_seams(const KnitGraph& graph) { return SeamPlaces(graph).plan(); }

KnitGraph cut_along(const KnitGraph& graph, const std::vector<Seam>& seams) {
  std::set<std::array<int, 2>> cut;
  for (const Seam& seam : seams) cut.insert(seam.columns.begin(), seam.columns.end());
  KnitGraph result = graph;
  result.columns.clear();
  result.column_lengths.clear();
  for (std::size_t i = 0; i < graph.columns.size(); ++i) {
    if (cut.count(graph.columns[i]) > 0) continue;
    result.columns.push_back(graph.columns[i]);
    result.column_lengths.push_back(graph.column_lengths[i]);
  }
  return result;
}

}  // namespace meshknit
