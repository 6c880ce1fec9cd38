#pragma once

#include <functional>
#include <vector>

#include "meshknit/surface/triangle_mesh.h"

namespace meshknit {

/// A vertex whose distance is known to begin with.
struct MarchSeed {
  int vertex = -1;
  double distance = 0.0;  ///< mm
};

/// How far a point is from the segment a-b, to seed a march from a curve.
double distance_to_segment(const Eigen::Vector3d& p, const Eigen::Vector3d& a,
                           const Eigen::Vector3d& b);

/// Distance of every vertex from the seeds, out to `limit` mm, infinite beyond and where `passable`
/// says no. Fast marching (Kimmel and Sethian 1998): near enough for counting the rows that are
/// left, and linear in the strip where exact windows would multiply. `distance` holds one number a
/// vertex, infinite where nothing is known yet; smaller numbers in it are kept.
void march(const TriangleMesh& mesh, const std::vector<double>& edge_length,
           const std::vector<MarchSeed>& seeds, double limit,
           const std::function<bool(int)>& passable, std::vector<double>& distance);

/// One length an edge, mm.
std::vector<double> edge_lengths(const TriangleMesh& mesh);

}  // namespace meshknit
