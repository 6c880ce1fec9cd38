#pragma once

#include <vector>

#include "meshknit/surface/surface.h"

namespace meshknit {

/// The mesh vertex nearest to a point (mm); the lowest index of equally near ones; -1 if there
/// are none.
int nearest_vertex(const Surface& surface, const Eigen::Vector3d& point);

/// The boundary with the vertex nearest to a point (mm); -1 if there are none.
int nearest_boundary(const Surface& surface, const Eigen::Vector3d& point);

/// Shortest path along mesh edges through these vertices in order (back to the first if closed,
/// which is then not repeated): a vertex chain without immediate repeats. Deterministic: ties
/// go to the lower index.
/// Throws: InvalidInput for a vertex that is not in the mesh, or one that no edges lead to.
std::vector<int> edge_path(const Surface& surface, const std::vector<int>& vertices,
                           bool closed = false);

}  // namespace meshknit
