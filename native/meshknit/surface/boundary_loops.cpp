#include "meshknit/surface/boundary_loops.h"

#include <algorithm>

namespace meshknit {

std::vector<BoundaryLoop> boundary_loops(const TriangleMesh& mesh,
                                         const std::vector<int>& source_vertex) {
  const auto by_source = [&](int a, int b) { return source_vertex[a] < source_vertex[b]; };
  std::vector<BoundaryLoop> loops;
  std::vector<bool> seen(mesh.n_halfedges(), false);
  for (const auto start : mesh.halfedges()) {
    if (!mesh.is_boundary(start) || seen[start.idx()]) continue;
    BoundaryLoop loop;
    // A half edge without a face has the surface on its right, so the loop goes against it.
    OpenMesh::HalfedgeHandle half = start;
    do {
      seen[half.idx()] = true;
      loop.vertices.push_back(mesh.to_vertex_handle(half).idx());
      loop.length += mesh.calc_edge_length(half);
      half = mesh.prev_halfedge_handle(half);
    } while (half != start);
    std::rotate(loop.vertices.begin(),
                std::min_element(loop.vertices.begin(), loop.vertices.end(), by_source),
                loop.vertices.end());
    loops.push_back(std::move(loop));
  }
  std::sort(loops.begin(), loops.end(), [&](const BoundaryLoop& a, const BoundaryLoop& b) {
    return by_source(a.vertices.front(), b.vertices.front());
  });
  return loops;
}

}  // namespace meshknit
