#pragma once

#include <array>

#include "meshknit/surface/triangle_mesh.h"

namespace meshknit {

/// The point of a triangle that is nearest to `point`.
Eigen::Vector3d nearest_in_triangle(const std::array<Eigen::Vector3d, 3>& corner,
                                    const Eigen::Vector3d& point);

/// A place on a mesh.
struct SurfacePoint {
  int face = -1;
  Eigen::Vector3d position = Eigen::Vector3d::Zero();
};

/// The place of a mesh that is nearest to a point, in the face of the lowest index among equals;
/// face -1 if the mesh has none.
SurfacePoint nearest_face(const TriangleMesh& mesh, const Eigen::Vector3d& point);

/// The corners of a face.
std::array<Eigen::Vector3d, 3> corners_of(const TriangleMesh& mesh, int face);

}  // namespace meshknit
