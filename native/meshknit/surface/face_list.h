#pragma once

#include <array>
#include <vector>

#include "meshknit/surface/triangle_mesh.h"

namespace meshknit {

/// Faces under examination, before there is a half-edge mesh that could hold them: vertex rows
/// of the input, and for each face its row of the input.
struct FaceList {
  std::vector<std::array<int, 3>> corners;
  std::vector<int> source;
};

/// All faces of the input.
/// Throws: InvalidInput if a face names a vertex that is not there.
FaceList list_faces(const VertexArray& vertices, const FaceArray& faces);

/// Removes the faces that name a vertex twice; returns their sources.
std::vector<int> remove_collapsed_faces(FaceList& faces);

/// Removes every face with the same three vertices as an earlier one; returns their sources.
std::vector<int> remove_repeated_faces(FaceList& faces);

/// One side of a face. Its edge joins a < b; `forward` tells whether the face runs from a to b.
struct FaceSide {
  int a = 0, b = 0;
  int face = 0;    ///< index into the list
  int corner = 0;  ///< the side runs from this corner to the next
  bool forward = true;
};

/// All sides, those of one edge together, edges in ascending order of (a, b), then by face.
std::vector<FaceSide> sorted_sides(const FaceList& faces);

/// Calls visit(first, last) with the run of sides of every edge.
template <typename Visit>
void for_each_edge(const std::vector<FaceSide>& sides, Visit visit) {
  for (auto first = sides.begin(); first != sides.end();) {
    auto last = first;
    while (last != sides.end() && last->a == first->a && last->b == first->b) ++last;
    visit(first, last);
    first = last;
  }
}

}  // namespace meshknit
