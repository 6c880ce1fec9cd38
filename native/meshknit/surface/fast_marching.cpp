#include "meshknit/surface/fast_marching.h"

#include <algorithm>
#include <cmath>
#include <functional>
#include <queue>
#include <utility>

#include "meshknit/surface/segment.h"

namespace meshknit {
namespace {

// Distance at the third corner of a triangle whose other two corners a and b have theirs: a plane wave
// through both, or along an edge where the wave would not come through the triangle.
double through_triangle(double d_a, double d_b, const Eigen::Vector3d& to_a,
                        const Eigen::Vector3d& to_b) {
  const double along_edges = std::min(d_a + to_a.norm(), d_b + to_b.norm());
  // Q = (V V^T)^-1 with V the two edges; d solves 1^T Q 1 d^2 - 2 1^T Q p d + p^T Q p - 1 = 0.
  Eigen::Matrix2d gram;
  gram << to_a.dot(to_a), to_a.dot(to_b), to_a.dot(to_b), to_b.dot(to_b);
  if (!(gram.determinant() > 0.0)) return along_edges;
  const Eigen::Matrix2d q = gram.inverse();
  const Eigen::Vector2d ones(1.0, 1.0), p(d_a, d_b);
  const double a = ones.dot(q * ones), b = ones.dot(q * p), c = p.dot(q * p) - 1.0;
  const double inside = b * b - a * c;
  if (inside < 0.0) return along_edges;
  const double d = (b + std::sqrt(inside)) / a;
  const Eigen::Vector2d slope = q * (p - d * ones);
  // Distances must grow from triangle to triangle, also over obtuse ones, or the march would not end.
  const bool through = slope.maxCoeff() < 0.0 && d > p.maxCoeff();
  return through ? std::min(d, along_edges) : along_edges;
}

}  // namespace

double distance_to_segment(const Eigen::Vector3d& p, const Eigen::Vector3d& a,
                           const Eigen::Vector3d& b) {
  return (a + nearest_along(a, b, p) * (b - a) - p).norm();
}

std::vector<double> edge_lengths(const TriangleMesh& mesh) {
  std::vector<double> lengths(mesh.n_edges());
  for (const auto e : mesh.edges()) lengths[e.idx()] = mesh.calc_edge_length(e);
  return lengths;
}

void march(const TriangleMesh& mesh, const std::vector<double>& edge_length,
           const std::vector<MarchSeed>& seeds, double limit,
           const std::function<bool(int)>& passable, std::vector<double>& distance) {
  std::priority_queue<std::pair<double, int>, std::vector<std::pair<double, int>>,
                      std::greater<>>
      queue;
  const auto offer = [&](int v, double d) {
    if (d >= distance[v] || d > limit || !passable(v)) return;
    distance[v] = d;
    queue.push({d, v});
  };
  for (const MarchSeed& seed : seeds) offer(seed.vertex, seed.distance);
  while (!queue.empty()) {
    const auto [d, v] = queue.top();
    queue.pop();
    if (d > distance[v]) continue;
    for (const auto h : mesh.voh_range(TriangleMesh::VertexHandle(v))) {
      const int w = mesh.to_vertex_handle(h).idx();
      offer(w, d + edge_length[h.idx() >> 1]);
      if (mesh.is_boundary(h)) continue;
      const int third = mesh.to_vertex_handle(mesh.next_halfedge_handle(h)).idx();
      for (const auto& [known, other] : {std::pair<int, int>{w, third}, {third, w}})
        if (std::isfinite(distance[known]) && passable(known))
          offer(other, through_triangle(d, distance[known],
                                        mesh.point(TriangleMesh::VertexHandle(v)) -
                                            mesh.point(TriangleMesh::VertexHandle(other)),
                                        mesh.point(TriangleMesh::VertexHandle(known)) -
                                            mesh.point(TriangleMesh::VertexHandle(other))));
    }
  }
}

}  // namespace meshknit
