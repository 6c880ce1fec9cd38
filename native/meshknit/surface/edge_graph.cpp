#include "meshknit/surface/edge_graph.h"

#include <algorithm>
#include <cmath>
#include <functional>
#include <limits>
#include <queue>
#include <string>
#include <utility>

#include "meshknit/core/error.h"

namespace meshknit {
namespace {

constexpr double kFar = std::numeric_limits<double>::infinity();

// A straight line is never longer than a way along edges. A hair less keeps that true of
// rounded sums, so that a vertex is done when it is taken from the queue.
constexpr double kNoLonger = 1.0 - 1e-9;

}  // namespace

EdgeGraph::EdgeGraph(const VertexArray& positions, const EdgeArray& edges)
    : positions_(positions),
      first_(positions.rows() + 1, 0),
      distance_(positions.rows(), kFar),
      previous_(positions.rows(), -1) {
  std::vector<double> lengths(edges.rows());
  for (int row = 0; row < edges.rows(); ++row) {
    for (const int v : edges.row(row)) require_vertex(v);
    lengths[row] = (positions.row(edges(row, 0)) - positions.row(edges(row, 1))).norm();
    if (!std::isfinite(lengths[row])) continue;
    for (const int v : edges.row(row)) ++first_[v + 1];
  }
  for (std::size_t v = 1; v < first_.size(); ++v) first_[v] += first_[v - 1];
  ways_.resize(first_.back());
  std::vector<std::size_t> next(first_.begin(), first_.end() - 1);
  for (int row = 0; row < edges.rows(); ++row) {
    if (!std::isfinite(lengths[row])) continue;
    const int a = edges(row, 0), b = edges(row, 1);
    ways_[next[a]++] = {b, row, lengths[row]};
    ways_[next[b]++] = {a, row, lengths[row]};
  }
}

std::vector<int> EdgeGraph::path(int from, int to) {
  require_vertex(from);
  require_vertex(to);
  search(from, to);
  if (distance_[to] == kFar) return {};
  std::vector<int> chain = {to};
  while (chain.back() != from) chain.push_back(previous_[chain.back()]);
  std::reverse(chain.begin(), chain.end());
  return chain;
}

std::vector<int> EdgeGraph::edges_along(const std::vector<int>& chain) const {
  std::vector<int> rows;
  for (std::size_t i = 0; i < chain.size(); ++i) {
    require_vertex(chain[i]);
    if (i == 0) continue;
    const auto begin = ways_.begin() + first_[chain[i - 1]];
    const auto end = ways_.begin() + first_[chain[i - 1] + 1];
    const auto way = std::find_if(begin, end, [&](const Way& w) { return w.to == chain[i]; });
    if (way == end)
      throw InvalidInput("edge_graph: no edge joins vertices " + std::to_string(chain[i - 1]) +
                         " and " + std::to_string(chain[i]));
    rows.push_back(way->edge);
  }
  return rows;
}

void EdgeGraph::search(int from, int to) {
  for (const int v : touched_) distance_[v] = kFar;
  touched_ = {from};
  distance_[from] = 0.0;
  // Where a lone vertex is not finite its distance would put the queue out of order.
  if (!positions_.row(to).allFinite()) return;
  const auto bound = [&](int v) {
    return distance_[v] + kNoLonger * (positions_.row(v) - positions_.row(to)).norm();
  };
  using Entry = std::pair<double, std::pair<double, int>>;  // bound, distance, vertex
  std::priority_queue<Entry, std::vector<Entry>, std::greater<>> queue;
  queue.push({bound(from), {0.0, from}});
  while (!queue.empty()) {
    const auto [least, entry] = queue.top();
    const auto [reached, v] = entry;
    queue.pop();
    // Not already at the goal: a way equally long may come from a lower vertex.
    if (least > distance_[to]) return;
    if (reached > distance_[v]) continue;
    for (std::size_t i = first_[v]; i < first_[v + 1]; ++i) {
      const int next = ways_[i].to;
      const double distance = reached + ways_[i].length;
      if (distance < distance_[next]) {
        if (distance_[next] == kFar) touched_.push_back(next);
        distance_[next] = distance;
        previous_[next] = v;
        queue.push({bound(next), {distance, next}});
      } else if (distance == distance_[next] && reached < distance && v < previous_[next]) {
        previous_[next] =
            v;  // never along an edge without length: two ends would name each other
      }
    }
  }
}

void EdgeGraph::require_vertex(int v) const {
  if (v < 0 || v >= positions_.rows())
    throw InvalidInput("edge_graph: the mesh has no vertex " + std::to_string(v));
}

}  // namespace meshknit
