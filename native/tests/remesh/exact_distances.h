#pragma once

#include <vector>

#include "remesh/peeled_surface.h"

namespace meshknit {

/// A place on the fine mesh of a peeled surface.
struct MeshPlace {
  int face = -1;  ///< of the fine mesh
  Eigen::Vector3d position;
};

/// Exact surface distances from the active cycle, by CGAL (Xin and Wang's version of Chen and
/// Han's method) on the shape's own coarse mesh: other code, another algorithm, another mesh.
/// The cycle stands for points 0.25 mm apart, which lengthens a distance d by at most
/// sqrt(d^2 + 0.125^2) - d: 0.01 mm at 0.8 mm. Requires: no place is further than 5 mm from the
/// cycle.
std::vector<double> exact_distances(const TimedShape& shape, const PeeledSurface& peeled,
                                    const std::vector<MeshPlace>& places);

}  // namespace meshknit
