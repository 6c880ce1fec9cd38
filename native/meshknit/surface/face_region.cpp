#include "meshknit/surface/face_region.h"

#include <algorithm>
#include <set>

#include "meshknit/surface/disjoint_sets.h"

namespace meshknit {

RegionShape region_shape(const TriangleMesh& mesh, const std::vector<int>& faces,
                         const std::vector<char>& inside) {
  RegionShape shape;
  std::set<int> vertices, edges, border;
  DisjointSets together(mesh.n_vertices());
  for (const int f : faces) {
    for (const auto half : mesh.fh_range(OpenMesh::FaceHandle(f))) {
      const auto from = mesh.from_vertex_handle(half);
      vertices.insert(from.idx());
      edges.insert(mesh.edge_handle(half).idx());
      shape.at_boundary = shape.at_boundary || mesh.is_boundary(from);
      const auto back = mesh.opposite_halfedge_handle(half);
      if (mesh.is_boundary(back) || inside[mesh.face_handle(back).idx()]) continue;
      border.insert(from.idx());
      together.unite(from.idx(), mesh.to_vertex_handle(half).idx());
    }
  }
  shape.characteristic = static_cast<int>(vertices.size()) - static_cast<int>(edges.size()) +
                         static_cast<int>(faces.size());
  std::set<int> roots;
  for (const int v : border) roots.insert(together.root(v));
  shape.rims = static_cast<int>(roots.size());
  return shape;
}

std::vector<std::vector<int>> islands(const TriangleMesh& mesh,
                                      const std::vector<int>& number) {
  std::vector<std::vector<int>> found;
  std::vector<bool> seen(mesh.n_faces(), false);
  for (std::size_t first = 0; first < number.size(); ++first) {
    if (number[first] == 0 || seen[first]) continue;
    std::vector<int> island{static_cast<int>(first)};
    seen[first] = true;
    for (std::size_t next = 0; next < island.size(); ++next)
      for (const auto other : mesh.ff_range(OpenMesh::FaceHandle(island[next]))) {
        if (seen[other.idx()] || number[other.idx()] != number[first]) continue;
        seen[other.idx()] = true;
        island.push_back(other.idx());
      }
    std::sort(island.begin(), island.end());
    found.push_back(std::move(island));
  }
  return found;
}

bool pinched_at(const TriangleMesh& mesh, OpenMesh::VertexHandle vertex,
                const std::vector<char>& left_out) {
  const auto kept = [&](OpenMesh::HalfedgeHandle half) {
    return !mesh.is_boundary(half) && !left_out[mesh.face_handle(half).idx()];
  };
  int fans = 0;
  for (const auto half : mesh.voh_range(vertex))
    fans += kept(half) && !kept(mesh.opposite_halfedge_handle(half));
  return fans > 1;
}

}  // namespace meshknit
