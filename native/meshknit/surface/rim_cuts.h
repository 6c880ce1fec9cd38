#pragma once

#include <vector>

#include "meshknit/surface/marching_tetrahedra.h"

namespace meshknit {

/// Where a limb ends in a flat, open rim: beyond a plane its cap is taken away.
struct RimCut {
  Eigen::Vector3d at = Eigen::Vector3d::Zero();        ///< mm, in the middle of the rim
  Eigen::Vector3d outward = Eigen::Vector3d::UnitZ();  ///< unit vector along the limb
};

/// Takes caps away, splitting faces near the planes. A cap is what lies beyond the plane and
/// hangs together with the vertex there that is nearest to the cut's middle: the plane does not
/// touch the rest of the body.
/// Returns for each vertex the number of the cut whose rim it lies on, or -1; the first faces and
/// vertices keep their order. Rim vertices are near the plane, but no nearer than a twentieth of the
/// edge to its ends, so that no face has zero area.
/// Requires: a closed manifold mesh.
/// Throws: InvalidInput if there is nothing beyond a plane, or everything.
std::vector<int> cut_rims(BlobMesh& mesh, const std::vector<RimCut>& cuts);

}  // namespace meshknit
