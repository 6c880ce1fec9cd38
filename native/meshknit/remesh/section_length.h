#pragma once

#include <Eigen/Core>

#include "meshknit/surface/triangle_mesh.h"

namespace meshknit {

/// A point in a triangle.
struct FacePoint {
  int face = -1;
  Eigen::Vector3d position;
};

/// The way between two points over the surface.
struct Section {
  double length = 0.0;         ///< mm
  Eigen::Vector3d from_first;  ///< unit direction in which it leaves the first point
  Eigen::Vector3d from_last;   ///< and, walked back, the last one
};

/// Surface distance of two points a few triangles apart: the length of the section of the
/// surface with the plane through both points and their mean normal. It differs from the
/// geodesic by a term of higher order in their distance. Over sharp edges both ways
/// round the plane are tried. The straight way where the section leaves the surface.
/// Requires: two points in different places.
Section section(const TriangleMesh& mesh, const FacePoint& from, const FacePoint& to);
/// The same with the sum of the two triangles' unit normals, for whoever has it already.
Section section(const TriangleMesh& mesh, const FacePoint& from, const FacePoint& to,
                const Eigen::Vector3d& normal);
/// Its length alone; zero for two points in one place.
double section_length(const TriangleMesh& mesh, const FacePoint& from, const FacePoint& to);

/// Unit normal of a triangle.
Eigen::Vector3d face_normal(const TriangleMesh& mesh, int face);

}  // namespace meshknit
