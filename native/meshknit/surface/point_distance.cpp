#include "meshknit/surface/point_distance.h"

#include <algorithm>
#include <cmath>
#include <functional>
#include <limits>
#include <queue>
#include <utility>

namespace meshknit {
namespace {

// A vertex that comes nearer by less than this part of its distance does not tell its
// neighbours: the march ends.
constexpr double least_gain = 1e-9;

// The unfolded source seen from an edge on the x axis: its place along the edge, and how far
// below it is. False if no point has these distances.
bool unfold(double at_begin, double at_end, double length, double& x, double& depth) {
  x = (length * length + at_begin * at_begin - at_end * at_end) / (2.0 * length);
  const double squared = at_begin * at_begin - x * x;
  depth = std::sqrt(std::max(0.0, squared));
  return squared >= -1e-9 * length * length;
}

// The distance at the third corner of a triangle, infinite where the straight way to it does not
// come through the edge of the two known ones.
double through_triangle(double d_a, double d_b, double ab, double ca, double cb) {
  constexpr double nothing = std::numeric_limits<double>::infinity();
  double x, depth;
  if (!(ab > 0.0) || !unfold(d_a, d_b, ab, x, depth)) return nothing;
  const double c_x = (ab * ab + ca * ca - cb * cb) / (2.0 * ab);
  const double c_y = std::sqrt(std::max(0.0, ca * ca - c_x * c_x));
  if (!(depth + c_y > 0.0)) return nothing;
  const double entry = x + (c_x - x) * depth / (depth + c_y);
  // A little to the side is fine: the error is of second order, and no corner falls between two
  // triangles.
  if (entry < -1e-3 * ab || entry > 1.001 * ab) return nothing;
  return std::hypot(c_x - x, c_y + depth);
}

}  // namespace

std::vector<double> distance_from(const TriangleMesh& mesh, const SurfacePoint& source,
                                  double limit) {
  using VertexHandle = TriangleMesh::VertexHandle;
  std::vector<double> distance(mesh.n_vertices(), std::numeric_limits<double>::infinity());
  std::priority_queue<std::pair<double, int>, std::vector<std::pair<double, int>>,
                      std::greater<>>
      queue;
  const auto offer = [&](VertexHandle v, double d) {
    if (!(d <= limit) || d >= (1.0 - least_gain) * distance[v.idx()]) return;
    distance[v.idx()] = d;
    queue.push({d, v.idx()});
  };
  for (const auto v : mesh.fv_range(OpenMesh::FaceHandle(source.face)))
    offer(v, (mesh.point(v) - source.position).norm());
  while (!queue.empty()) {
    const auto [d, at] = queue.top();
    queue.pop();
    if (d > distance[at]) continue;
    const VertexHandle v(at);
    for (const auto h : mesh.voh_range(v)) {
      const VertexHandle w = mesh.to_vertex_handle(h);
      const double vw = mesh.calc_edge_length(h);
      offer(w, d + vw);
      if (mesh.is_boundary(h)) continue;
      const auto next = mesh.next_halfedge_handle(h);
      const VertexHandle third = mesh.to_vertex_handle(next);
      const double w_third = mesh.calc_edge_length(next);
      const double v_third = mesh.calc_edge_length(mesh.next_halfedge_handle(next));
      if (std::isfinite(distance[w.idx()]))
        offer(third, through_triangle(d, distance[w.idx()], vw, v_third, w_third));
      if (std::isfinite(distance[third.idx()]))
        offer(w, through_triangle(d, distance[third.idx()], v_third, vw, w_third));
    }
  }
  return distance;
}

double level_crossing(double low, double high, double length, double level) {
  double x, depth;
  if (length > 0.0 && unfold(low, high, length, x, depth) && level >= depth) {
    const double place = x + std::sqrt(level * level - depth * depth);
    if (place >= 0.0 && place <= length) return place / length;
  }
  return high > low ? std::clamp((level - low) / (high - low), 0.0, 1.0) : 0.5;
}

}  // namespace meshknit
