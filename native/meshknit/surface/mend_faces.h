#pragma once

#include <vector>

#include "meshknit/core/problem.h"
#include "meshknit/surface/face_list.h"

namespace meshknit {

/// Faces after mending what can be mended without changing the shape.
struct MendedFaces {
  FaceList faces;                   ///< name representatives only
  std::vector<int> representative;  ///< vertex -> the vertex that stands for it
  Problems problems;  ///< notes of what was mended; errors if nothing can be made of the arrays
};

/// Removes collapsed and repeated faces and joins doubled vertices (within 1e-6 of the bounding
/// box's diagonal).
MendedFaces mend_faces(const VertexArray& vertices, FaceList faces);

/// Faces whose height is below 1e-9 of their longest side.
std::vector<int> zero_area_faces(const VertexArray& vertices, const FaceList& faces);

}  // namespace meshknit
