#pragma once

#include <array>
#include <vector>

#include "meshknit/surface/face_list.h"

namespace meshknit {

/// How the faces hang together across their edges.
struct Orientation {
  std::vector<int> piece;  ///< per face; pieces count from 0 in order of their first face
  int pieces = 0;
  std::vector<int> flipped;  ///< faces of the list that were turned, the fewer of each piece
  std::vector<std::array<int, 2>>
      contradictions;  ///< edges across which no turning makes faces agree
};

/// Turns faces so that neighbours agree on which side is outside. In every piece the majority
/// stays as it is, and on a tie the first face.
/// Requires: `sides` are the sorted sides of `faces`, no edge with three faces. They are stale
/// afterwards.
Orientation orient_faces(FaceList& faces, const std::vector<FaceSide>& sides);

/// Vertices where several fans of faces meet in nothing but the vertex, ascending.
/// Requires: as above.
std::vector<int> pinched_vertices(const FaceList& faces, const std::vector<FaceSide>& sides);

}  // namespace meshknit
