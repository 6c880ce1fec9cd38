#pragma once

#include <vector>

#include "meshknit/surface/triangle_mesh.h"

namespace meshknit {

/// Splits an edge, and the one or two faces at it, with a new vertex at `point`. Every new face
/// takes over what `origin` (one entry a face) says of the face that it is a part of. Other
/// edges and faces keep their handles.
template <typename Origin>
OpenMesh::VertexHandle split_edge(TriangleMesh& mesh, std::vector<Origin>& origin,
                                  OpenMesh::EdgeHandle edge, const Eigen::Vector3d& point) {
  std::vector<std::pair<OpenMesh::VertexHandle, Origin>> opposite;
  for (int side = 0; side < 2; ++side) {
    const auto half = mesh.halfedge_handle(edge, side);
    if (mesh.is_boundary(half)) continue;
    opposite.push_back({mesh.to_vertex_handle(mesh.next_halfedge_handle(half)),
                        origin[mesh.face_handle(half).idx()]});
  }
  const OpenMesh::VertexHandle middle = mesh.add_vertex(point);
  mesh.split(edge, middle);
  origin.resize(mesh.n_faces());
  for (const auto spoke : mesh.voh_range(middle))
    for (const auto& [vertex, from] : opposite)
      if (mesh.to_vertex_handle(spoke) == vertex) {
        origin[mesh.face_handle(spoke).idx()] = from;
        origin[mesh.face_handle(mesh.opposite_halfedge_handle(spoke)).idx()] = from;
      }
  return middle;
}

}  // namespace meshknit
