#pragma once

#include <functional>
#include <vector>

#include "meshknit/surface/triangle_mesh.h"

namespace meshknit {

/// The smooth surface that a mesh stands for.
struct SmoothSurface {
  /// The surface point nearest to a point that is near; `rim` is the number of the rim that the
  /// vertex must stay on, or -1.
  std::function<Eigen::Vector3d(const Eigen::Vector3d& point, int rim)> settle;
  /// The unit normal there, pointing out.
  std::function<Eigen::Vector3d(const Eigen::Vector3d& point)> normal;
};

/// Evens out a mesh: splits long edges, collapses short ones, flips edges to the Delaunay
/// condition and moves vertices to the middle of their neighbours, several times over (Botsch and
/// Kobbelt 2004, "A remeshing approach to multiresolution modeling"). Vertices end on the surface
/// and rim vertices on their rims; edges are mostly 0.8 to 1.33 times `edge_length` (mm) long.
/// `rim`: per vertex a number or -1, updated.
/// Requires: exactly the boundary vertices have a rim; rims longer than four edges.
/// Ensures: the topology is that of the input (a manifold mesh stays one).
void even_triangles(TriangleMesh& mesh, std::vector<int>& rim, const SmoothSurface& surface,
                    double edge_length);

}  // namespace meshknit
