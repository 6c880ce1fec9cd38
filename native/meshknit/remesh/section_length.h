#pragma once

#include <Eigen/Core>

#include "meshknit/surface/triangle_mesh.h"

namespace meshknit {

/// A point in a triangle.
struct FacePoint {
  int face = -1;
  Eigen::Vector3d position;
};

/// Surface distance of two points a few triangles apart: the length of the section of the
/// surface with the plane through both points and their mean normal. It differs from the
/// geodesic by a term of higher order in their distance. Over sharp edges both ways
/// round the plane are tried. The straight distance where the section leaves the surface.
double section_length(const TriangleMesh& mesh, const FacePoint& from, const FacePoint& to);

}  // namespace meshknit
