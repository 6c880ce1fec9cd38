#include "meshknit/suggest/rim_times.h"

#include <Eigen/LU>
#include <algorithm>
#include <cmath>
#include <functional>
#include <limits>
#include <queue>
#include <utility>

#include "meshknit/time_field/laplacian.h"

namespace meshknit {
namespace {

constexpr double infinity = std::numeric_limits<double>::infinity();

// Times that differ by no more than this are meant to be the same.
constexpr double alike = 0.04, step = 0.01;

std::vector<std::vector<int>> chains_of(const Surface& surface) {
  std::vector<std::vector<int>> chains;
  for (const BoundaryLoop& loop : surface.boundaries) chains.push_back(loop.vertices);
  return chains;
}

// Distance along edges from a boundary: for girths that is near enough.
std::vector<double> distance_from_loop(const TriangleMesh& mesh, const BoundaryLoop& loop) {
  using Entry = std::pair<double, int>;
  std::priority_queue<Entry, std::vector<Entry>, std::greater<>> queue;
  std::vector<double> distance(mesh.n_vertices(), infinity);
  for (const int v : loop.vertices) {
    distance[v] = 0.0;
    queue.push({0.0, v});
  }
  while (!queue.empty()) {
    const auto [d, v] = queue.top();
    queue.pop();
    if (d > distance[v]) continue;
    for (const auto h : mesh.voh_range(TriangleMesh::VertexHandle(v))) {
      const int w = mesh.to_vertex_handle(h).idx();
      const double there = d + mesh.calc_edge_length(h);
      if (!(there < distance[w])) continue;
      distance[w] = there;
      queue.push({there, w});
    }
  }
  return distance;
}

// How round the limb behind each boundary is: the area up to half way to the next boundary, over that
// way.
std::vector<double> girths(const Surface& surface) {
  std::vector<double> girth;
  for (std::size_t b = 0; b < surface.boundaries.size(); ++b) {
    const std::vector<double> distance =
        distance_from_loop(surface.mesh, surface.boundaries[b]);
    double way = infinity, area = 0.0;
    for (std::size_t other = 0; other < surface.boundaries.size(); ++other)
      if (other != b)
        for (const int v : surface.boundaries[other].vertices)
          way = std::min(way, 0.5 * distance[v]);
    for (const auto f : surface.mesh.faces()) {
      double middle = 0.0;
      for (const auto v : surface.mesh.fv_range(f)) middle += distance[v.idx()] / 3.0;
      if (middle < way) area += surface.mesh.calc_face_area(f);
    }
    girth.push_back(std::max(area / way, 1e-3 * surface.boundaries[b].length));
  }
  return girth;
}

// Equal where they are alike, from the earliest up; in whole steps.
void make_alike(std::vector<double>& times) {
  std::vector<std::size_t> order(times.size());
  for (std::size_t k = 0; k < order.size(); ++k) order[k] = k;
  std::stable_sort(order.begin(), order.end(),
                   [&](std::size_t a, std::size_t b) { return times[a] < times[b]; });
  for (std::size_t k = 0; k < order.size();) {
    std::size_t end = k + 1;
    while (end < order.size() && times[order[end]] - times[order[end - 1]] <= alike) ++end;
    double time = 0.0;
    for (std::size_t i = k; i < end; ++i)
      time += times[order[i]] / static_cast<double>(end - k);
    if (k == 0) time = -1.0;
    if (end == order.size()) time = 1.0;
    for (; k < end; ++k) times[order[k]] = step * std::round(time / step);
  }
}

}  // namespace

RimTimes::RimTimes(const Surface& surface)
    : solver_(surface, chains_of(surface)), girth_(girths(surface)) {
  const auto rims = static_cast<Eigen::Index>(surface.boundaries.size());
  std::vector<int> rim_of(surface.mesh.n_vertices(), -1);
  for (std::size_t b = 0; b < surface.boundaries.size(); ++b)
    for (const int v : surface.boundaries[b].vertices) rim_of[v] = static_cast<int>(b);
  const std::vector<EdgeWeight> weights =
      laplacian_weights(surface.mesh, LaplacianKind::intrinsic_delaunay);
  flux_ = Eigen::MatrixXd::Zero(rims, rims);
  for (Eigen::Index s = 0; s < rims; ++s) {
    std::vector<double> times(static_cast<std::size_t>(rims), 0.0);
    times[static_cast<std::size_t>(s)] = 1.0;
    const std::vector<double> field = solver_.solve(times);
    for (const EdgeWeight& w : weights) {
      if (rim_of[w.a] >= 0) flux_(rim_of[w.a], s) += w.weight * (field[w.a] - field[w.b]);
      if (rim_of[w.b] >= 0) flux_(rim_of[w.b], s) += w.weight * (field[w.b] - field[w.a]);
    }
  }
}

std::vector<double> RimTimes::even_times(const std::vector<char>& is_start) const {
  const auto rims = static_cast<Eigen::Index>(is_start.size());
  double in = 0.0, out = 0.0;
  for (std::size_t b = 0; b < is_start.size(); ++b) (is_start[b] ? in : out) += girth_[b];
  Eigen::VectorXd wanted(rims);
  for (std::size_t b = 0; b < is_start.size(); ++b)
    wanted[static_cast<Eigen::Index>(b)] = is_start[b] ? -girth_[b] / in : girth_[b] / out;
  // All times may be shifted together: the first one is 0.
  Eigen::VectorXd found = Eigen::VectorXd::Zero(rims);
  const Eigen::Index rest = rims - 1;
  found.tail(rest) =
      flux_.bottomRightCorner(rest, rest).partialPivLu().solve(wanted.tail(rest));
  const double low = found.minCoeff(), high = found.maxCoeff();
  std::vector<double> times;
  for (Eigen::Index b = 0; b < rims; ++b)
    times.push_back(high > low ? -1.0 + 2.0 * (found[b] - low) / (high - low) : 0.0);
  make_alike(times);
  return times;
}

}  // namespace meshknit
