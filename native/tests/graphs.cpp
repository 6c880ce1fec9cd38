#include "graphs.h"

#include <algorithm>
#include <cmath>
#include <stdexcept>

namespace meshknit {
namespace {

using Front = GraphDrawing::Front;

const double kPi = 3.14159265358979323846;

int nodes_below(char link) { return link == 'A' ? 2 : 1; }

int count_below(const std::string& links) {
  int count = 0;
  for (const char link : links) count += nodes_below(link);
  return count;
}

}  // namespace

Front GraphDrawing::cast_on(int n) {
  KnitRow row;
  const double radius = n * graph_.stitch_width / (2.0 * kPi);
  for (int i = 0; i < n; ++i) {
    const double angle = 2.0 * kPi * i / n;
    KnitNode node;
    node.position = {radius * std::cos(angle), radius * std::sin(angle), 0.0};
    row.nodes.push_back(static_cast<int>(graph_.nodes.size()));
    graph_.nodes.push_back(node);
    level_.push_back(0);
  }
  graph_.rows.push_back(row);
  return row.nodes;
}

Front GraphDrawing::add_row(const Front& covered, const std::string& links, bool closed) {
  if (count_below(links) != static_cast<int>(covered.size()))
    throw std::invalid_argument("the links \"" + links + "\" do not fit the front");
  int level = 0;
  for (const int node : covered) level = std::max(level, level_[node] + 1);

  KnitRow row;
  row.closed = closed;
  int below = 0;
  for (const char link : links) {
    const int nodes_above = link == 'Y' ? 2 : 1;
    KnitNode node;
    node.position.setZero();
    for (int i = 0; i < nodes_below(link); ++i)
      node.position += graph_.nodes[covered[below + i]].position / nodes_below(link);
    node.position.z() = level * 2.0 * graph_.stitch_height;
    for (int k = 0; k < nodes_above; ++k) {
      const int id = static_cast<int>(graph_.nodes.size());
      graph_.nodes.push_back(node);
      level_.push_back(level);
      row.nodes.push_back(id);
      for (int i = 0; i < nodes_below(link); ++i)
        graph_.columns.push_back({covered[below + i], id});
    }
    below += nodes_below(link);
  }
  graph_.rows.push_back(row);
  return row.nodes;
}

Front GraphDrawing::closed_row(const Front& front, const std::string& links, int begin) {
  const Front above = add_row(front, links, true);
  int first = 0;
  for (int k = 0; k < begin; ++k) first += links[k] == 'Y' ? 2 : 1;
  std::vector<int>& nodes = graph_.rows.back().nodes;
  std::rotate(nodes.begin(), nodes.begin() + first, nodes.end());
  return above;
}

Front GraphDrawing::short_row(const Front& front, int begin, const std::string& links) {
  Front turned = front;
  std::rotate(turned.begin(), turned.begin() + begin, turned.end());
  const int covered = count_below(links);
  Front next = add_row(Front(turned.begin(), turned.begin() + covered), links, false);
  const int row_size = static_cast<int>(next.size());
  next.insert(next.end(), turned.begin() + covered, turned.end());

  // Turn back, so that the new front begins where the old one did.
  const int to_seam = static_cast<int>(front.size()) - begin;
  int first = 0;
  if (covered > to_seam) {
    int below = 0;
    for (const char link : links) {
      if (below >= to_seam) break;
      below += nodes_below(link);
      first += link == 'Y' ? 2 : 1;
    }
  } else {
    first = row_size + to_seam - covered;
  }
  std::rotate(next.begin(), next.begin() + first % static_cast<int>(next.size()), next.end());
  return next;
}

KnitGraph GraphDrawing::graph() const {
  KnitGraph graph = graph_;
  std::stable_sort(graph.columns.begin(), graph.columns.end(),
                   [](const auto& a, const auto& b) { return a[0] < b[0]; });
  for (const KnitRow& row : graph.rows)
    graph.row_lengths.emplace_back(row.nodes.size() - (row.closed ? 0 : 1), graph.stitch_width);
  graph.column_lengths.assign(graph.columns.size(), 2.0 * graph.stitch_height);
  const int top = std::max(1, *std::max_element(level_.begin(), level_.end()));
  for (std::size_t i = 0; i < graph.nodes.size(); ++i)
    graph.nodes[i].time = 2.0 * level_[i] / top - 1.0;
  return graph;
}

std::string links(int n, char kind) { return std::string(n, kind); }

KnitGraph plain_tube(int n, int rows) {
  return shaped_tube(n, std::vector<std::string>(rows - 1, links(n)));
}

KnitGraph shaped_tube(int n, const std::vector<std::string>& rows) {
  GraphDrawing drawing;
  Front front = drawing.cast_on(n);
  for (const std::string& row : rows) front = drawing.closed_row(front, row);
  return drawing.graph();
}

KnitGraph tube_with_short_rows(int n, const std::vector<DrawnShortRow>& short_rows,
                               int rows_after) {
  GraphDrawing drawing;
  Front front = drawing.cast_on(n);
  for (const auto& [begin, row_links] : short_rows)
    front = drawing.short_row(front, begin, row_links);
  for (int i = 0; i < rows_after; ++i)
    front = drawing.closed_row(front, links(static_cast<int>(front.size())));
  return drawing.graph();
}

KnitGraph one_short_row() { return tube_with_short_rows(10, {{3, "||||"}}); }

KnitGraph short_row_over_seam() { return tube_with_short_rows(10, {{8, "|||||"}}); }

KnitGraph nested_short_rows() {
  return tube_with_short_rows(12, {{2, "||||||||"}, {3, "||||||"}, {4, "||||"}});
}

KnitGraph short_row_with_increase() { return tube_with_short_rows(10, {{3, "||Y||"}}); }

KnitGraph stacked_short_rows(int k) {
  return tube_with_short_rows(10, std::vector<DrawnShortRow>(k, {3, "||||"}));
}

KnitGraph helix() {
  GraphDrawing drawing;
  drawing.cast_on(18);
  KnitGraph graph = drawing.graph();
  graph.rows[0].closed = false;
  graph.row_lengths[0].pop_back();
  for (int i = 0; i + 6 < 18; ++i) graph.columns.push_back({i, i + 6});
  graph.column_lengths.assign(graph.columns.size(), 2.0 * graph.stitch_height);
  return graph;
}

KnitGraph flipped_row() {
  KnitGraph graph = plain_tube(6, 3);
  std::reverse(graph.rows[1].nodes.begin(), graph.rows[1].nodes.end());
  return graph;
}

KnitGraph splitting_tube(int n) {
  GraphDrawing drawing;
  Front trunk = drawing.cast_on(2 * n);
  for (int i = 0; i < 2; ++i) trunk = drawing.closed_row(trunk, links(2 * n));
  Front left(trunk.begin(), trunk.begin() + n), right(trunk.begin() + n, trunk.end());
  for (int i = 0; i < 3; ++i) {
    left = drawing.closed_row(left, links(n));
    right = drawing.closed_row(right, links(n));
  }
  return drawing.graph();
}

KnitGraph merging_tube(int n) {
  GraphDrawing drawing;
  Front left = drawing.cast_on(n), right = drawing.cast_on(n);
  for (int i = 0; i < 2; ++i) {
    left = drawing.closed_row(left, links(n));
    right = drawing.closed_row(right, links(n));
  }
  Front trunk = left;
  trunk.insert(trunk.end(), right.begin(), right.end());
  for (int i = 0; i < 3; ++i) trunk = drawing.closed_row(trunk, links(2 * n));
  return drawing.graph();
}

KnitGraph three_way_split(int a, int b1, int c, int b2) {
  GraphDrawing drawing;
  Front trunk = drawing.cast_on(a + b1 + c + b2);
  trunk = drawing.closed_row(trunk, links(a + b1 + c + b2));
  const auto at = [&](int i) { return trunk.begin() + i; };
  Front middle(at(a), at(a + b1));
  middle.insert(middle.end(), at(a + b1 + c), trunk.end());
  for (Front tube : {Front(at(0), at(a)), middle, Front(at(a + b1), at(a + b1 + c))})
    for (int i = 0; i < 2; ++i)
      tube = drawing.closed_row(tube, links(static_cast<int>(tube.size())));
  return drawing.graph();
}

int Dice::roll(int sides) {
  state_ = state_ * 6364136223846793005u + 1442695040888963407u;
  // The high bits of such a generator are the random ones.
  return static_cast<int>((state_ >> 33) % static_cast<std::uint64_t>(sides));
}

}  // namespace meshknit
