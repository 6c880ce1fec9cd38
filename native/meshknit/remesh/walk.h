#pragma once

#include <Eigen/Core>
#include <array>

#include "meshknit/remesh/section_length.h"
#include "meshknit/surface/triangle_mesh.h"

namespace meshknit {

/// A triangle, for whoever comes back to it often.
struct TriangleCorners {
  std::array<TriangleMesh::HalfedgeHandle, 3> out;  ///< half edge that starts at each corner
  std::array<Eigen::Vector3d, 3> point;
  Eigen::Vector3d normal;  ///< not unit
};
TriangleCorners triangle_corners(const TriangleMesh& mesh, int face);

/// Weights of a triangle's corners at a point of its plane, in the order of its half edges'
/// start vertices beginning with the triangle's own half edge.
Eigen::Vector3d corner_weights(const TriangleMesh& mesh, const FacePoint& point);

/// Walks straight over the surface by a vector of the start triangle's plane (its normal part
/// is ignored), unfolding triangles on the way. The result lies in its triangle; a walk that
/// meets a boundary stops there, and its result has no triangle (-1).
FacePoint walk(const TriangleMesh& mesh, const FacePoint& from, const Eigen::Vector3d& by);

/// The same with the start triangle's corners at hand; they become those of the result's triangle, and
/// stay as they are if it has none.
FacePoint walk(const TriangleMesh& mesh, const FacePoint& from, const Eigen::Vector3d& by,
               TriangleCorners& corners);

}  // namespace meshknit
