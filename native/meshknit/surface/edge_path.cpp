#include "meshknit/surface/edge_path.h"

#include <limits>
#include <string>

#include "meshknit/core/error.h"
#include "meshknit/surface/edge_graph.h"

namespace meshknit {
namespace {

EdgeGraph edges_of(const TriangleMesh& mesh) {
  VertexArray positions(mesh.n_vertices(), 3);
  for (const auto v : mesh.vertices()) positions.row(v.idx()) = mesh.point(v);
  EdgeArray edges(mesh.n_edges(), 2);
  for (const auto e : mesh.edges())
    for (int end = 0; end < 2; ++end)
      edges(e.idx(), end) = mesh.to_vertex_handle(mesh.halfedge_handle(e, end)).idx();
  return {positions, edges};
}

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
  EdgeGraph graph = edges_of(surface.mesh);
  std::vector<int> chain = {vertices.front()};
  const auto go_to = [&](int v) {
    const std::vector<int> leg = graph.path(chain.back(), v);
    if (leg.empty())
      throw InvalidInput("edge_path: no edges lead from vertex " +
                         std::to_string(chain.back()) + " to vertex " + std::to_string(v));
    chain.insert(chain.end(), leg.begin() + 1, leg.end());
  };
  for (const int v : vertices) go_to(v);
  if (closed && chain.size() > 1) {
    go_to(vertices.front());
    if (chain.size() > 1 && chain.back() == chain.front()) chain.pop_back();
  }
  return chain;
}

}  // namespace meshknit
