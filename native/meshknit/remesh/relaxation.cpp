#include "meshknit/remesh/relaxation.h"

#include <array>

#include "meshknit/remesh/surface_springs.h"
#include "meshknit/remesh/walk.h"

namespace meshknit {
namespace {

// Errors beside shaping reach a few stitches far, so few rounds do most of the work.
constexpr int rounds = 100;

double value_at(const TriangleMesh& mesh, const std::vector<double>& of_vertex,
                const FacePoint& at) {
  // Rounding must not lead beyond the field's range.
  Eigen::Vector3d weight = corner_weights(mesh, at).cwiseMax(0.0);
  weight /= weight.sum();
  auto h = mesh.halfedge_handle(TriangleMesh::FaceHandle(at.face));
  double value = 0.0;
  for (int k = 0; k < 3; ++k, h = mesh.next_halfedge_handle(h))
    value += weight[k] * of_vertex[mesh.from_vertex_handle(h).idx()];
  return value;
}

}  // namespace

void relax_nodes(const TriangleMesh& mesh, const std::vector<double>& time,
                 std::vector<int>& faces, KnitGraph& graph,
                 const std::function<void(double)>& progress) {
  const std::size_t n = graph.nodes.size();
  SurfaceSprings points(mesh);
  for (std::size_t i = 0; i < n; ++i) points.add({faces[i], graph.nodes[i].position});
  std::vector<Spring> springs;
  for (const KnitRow& row : graph.rows)
    for (std::size_t i = 0; i + 1 < row.nodes.size() + row.closed; ++i)
      springs.push_back(
          {row.nodes[i], row.nodes[(i + 1) % row.nodes.size()], graph.stitch_width});
  std::vector<std::array<char, 2>> has(n, {0, 0});
  for (const auto& c : graph.columns) {
    springs.push_back({c[0], c[1], 2.0 * graph.stitch_height});
    has[c[0]][1] = has[c[1]][0] = 1;
  }
  std::vector<int> movable;
  for (std::size_t i = 0; i < n; ++i)
    if (has[i][0] && has[i][1]) movable.push_back(static_cast<int>(i));
  points.relax(springs, movable, rounds, progress);
  for (std::size_t i = 0; i < n; ++i) {
    const FacePoint& at = points.point(static_cast<int>(i));
    faces[i] = at.face;
    graph.nodes[i].position = at.position;
    graph.nodes[i].time = value_at(mesh, time, at);
  }
}

}  // namespace meshknit
