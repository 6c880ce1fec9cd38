#pragma once

#include <Eigen/Core>

// OpenMesh's mesh headers must come before its Eigen adapter.
// clang-format off
#include <OpenMesh/Core/Mesh/TriMesh_ArrayKernelT.hh>
#include <OpenMesh/Core/Geometry/EigenVectorT.hh>
// clang-format on

// Compiled once, in triangle_mesh.cpp: OpenMesh grows a property by a vector that Eigen leaves
// unset, and the compiler would warn of it in every source that includes this header.
extern template class OpenMesh::PropertyT<Eigen::Vector3d>;

namespace meshknit {

struct TriangleMeshTraits : OpenMesh::DefaultTraits {
  using Point = Eigen::Vector3d;
  using Normal = Eigen::Vector3d;
  VertexAttributes(OpenMesh::Attributes::None);
  HalfedgeAttributes(OpenMesh::Attributes::PrevHalfedge);
  EdgeAttributes(OpenMesh::Attributes::None);
  FaceAttributes(OpenMesh::Attributes::None);
};

/// The project's only mesh type: triangles, half edges, positions in mm. Faces run
/// anticlockwise seen from outside, so normals point out.
using TriangleMesh = OpenMesh::TriMesh_ArrayKernelT<TriangleMeshTraits>;

using VertexArray = Eigen::Matrix<double, Eigen::Dynamic, 3, Eigen::RowMajor>;
using FaceArray = Eigen::Matrix<int, Eigen::Dynamic, 3, Eigen::RowMajor>;

}  // namespace meshknit
