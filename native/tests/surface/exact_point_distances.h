#pragma once

#include <vector>

#include "meshknit/surface/nearest_face.h"
#include "surface/test_meshes.h"

namespace meshknit {

/// Exact surface distances (mm) from one place of a mesh to others, by CGAL (Xin and Wang's
/// version of Chen and Han's method): other code and another algorithm than ours. Places move by
/// a thousandth of the way to the middle of their face, since CGAL 5.5 errs on edges.
std::vector<double> exact_distances_from(const MeshArrays& arrays, const SurfacePoint& source,
                                         const std::vector<SurfacePoint>& places);

}  // namespace meshknit
