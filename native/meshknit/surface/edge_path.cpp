#include "meshknit/surface/edge_path.h"

#include <algorithm>
#include <functional>
#include <limits>
#include <queue>
#include <string>
#include <utility>

#include "meshknit/core/error.h"

namespace meshknit {
namespace {

// Dijkstra from one vertex to another. Arrays are kept between searches and only reset where
// the last search went, so a chain of many near points costs what its own length costs.
class EdgeSearch {
 public:
  explicit EdgeSearch(const TriangleMesh& mesh)
      : mesh_(mesh), distance_(mesh.n_vertices(), kFar), previous_(mesh.n_vertices(), -1) {}

  // The vertices after `from` up to `to`.
  std::vector<int> path(int from, int to) {
    search(from, to);
    if (distance_[to] == kFar)
      throw InvalidInput("edge_path: no edges lead from vertex " + std::to_string(from) +
                         " to vertex " + std::to_string(to));
    std::vector<int> chain;
    for (int v = to; v != from; v = previous_[v]) chain.push_back(v);
    std::reverse(chain.begin(), chain.end());
    return chain;
  }

 private:
  static constexpr double kFar = std::numeric_limits<double>::infinity();

  void search(int from, int to) {
    for (const int v : touched_) distance_[v] = kFar;
    touched_ = {from};
    distance_[from] = 0.0;
    using Entry = std::pair<double, int>;
    std::priority_queue<Entry, std::vector<Entry>, std::greater<>> queue;
    queue.push({0.0, from});
    while (!queue.empty()) {
      const auto [reached, v] = queue.top();
      queue.pop();
      if (v == to) return;
      if (reached > distance_[v]) continue;
      for (const auto half : mesh_.voh_range(OpenMesh::VertexHandle(v))) {
        const int next = mesh_.to_vertex_handle(half).idx();
        const double distance = reached + mesh_.calc_edge_length(half);
        if (distance < distance_[next]) {
          if (distance_[next] == kFar) touched_.push_back(next);
          distance_[next] = distance;
          previous_[next] = v;
          queue.push({distance, next});
        } else if (distance == distance_[next] && v < previous_[next]) {
          previous_[next] = v;
        }
      }
    }
  }

  const TriangleMesh& mesh_;
  std::vector<double> distance_;
  std::vector<int> previous_, touched_;
};

}  // namespace

int nearest_vertex(const Surface& surface, const Eigen::Vector3d& point) {
  int nearest = -1;
  double best = std::numeric_limits<double>::infinity();
  for (const auto v : surface.mesh.vertices()) {
    const double squared = (surface.mesh.point(v) - point).squaredNorm();
    if (squared < best) {
      best = squared;
      nearest = v.idx();
    }
  }
  return nearest;
}

int nearest_boundary(const Surface& surface, const Eigen::Vector3d& point) {
  int nearest = -1;
  double best = std::numeric_limits<double>::infinity();
  for (std::size_t b = 0; b < surface.boundaries.size(); ++b)
    for (const int v : surface.boundaries[b].vertices) {
      const double squared =
          (surface.mesh.point(OpenMesh::VertexHandle(v)) - point).squaredNorm();
      if (squared < best) {
        best = squared;
        nearest = static_cast<int>(b);
      }
    }
  return nearest;
}

std::vector<int> edge_path(const Surface& surface, const std::vector<int>& vertices,
                           bool closed) {
  for (const int v : vertices)
    if (v < 0 || v >= static_cast<int>(surface.mesh.n_vertices()))
      throw InvalidInput("edge_path: the mesh has no vertex " + std::to_string(v));
  if (vertices.empty()) return {};
  EdgeSearch search(surface.mesh);
  std::vector<int> chain = {vertices.front()};
  const auto go_to = [&](int v) {
    const std::vector<int> leg = search.path(chain.back(), v);
    chain.insert(chain.end(), leg.begin(), leg.end());
  };
  for (const int v : vertices) go_to(v);
  if (closed && chain.size() > 1) {
    go_to(vertices.front());
    if (chain.size() > 1 && chain.back() == chain.front()) chain.pop_back();
  }
  return chain;
}

}  // namespace meshknit
