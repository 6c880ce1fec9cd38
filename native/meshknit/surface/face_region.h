#pragma once

#include <array>
#include <vector>

#include "meshknit/surface/triangle_mesh.h"

namespace meshknit {

/// What a set of faces is, as a piece of the surface.
struct RegionShape {
  int characteristic = 0;    ///< V - E + F of the closed region; 1 for a disc
  int rims = 0;              ///< parts of its border to the other faces that hang together
  bool at_boundary = false;  ///< one of its vertices lies on the mesh's boundary
};

/// Requires: `inside` has an entry a face of the mesh.
RegionShape region_shape(const TriangleMesh& mesh, const std::vector<int>& faces,
                         const std::vector<char>& inside);

/// The islands that the chosen faces make: faces with the same number other than 0 that hang
/// together across edges, in the order of their first faces.
std::vector<std::vector<int>> islands(const TriangleMesh& mesh, const std::vector<int>& number);

/// True if the faces round a vertex that are not left out do not hang together there.
/// Requires: `left_out` has an entry a face.
bool pinched_at(const TriangleMesh& mesh, OpenMesh::VertexHandle vertex,
                const std::vector<char>& left_out);

}  // namespace meshknit
