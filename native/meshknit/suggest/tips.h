#pragma once

#include <vector>

#include "meshknit/core/run_context.h"
#include "meshknit/surface/triangle_mesh.h"

namespace meshknit {

/// Where a limb ends: a place that is further from everything else than all places around it.
struct Tip {
  int vertex = -1;
  /// How far it stands out: by how much (mm) its mean distance to the rest exceeds that of the place
  /// where its limb leaves the others. About the limb's length; infinite for the furthest tip of all.
  double prominence = 0.0;
};

/// The tips of a connected mesh, most prominent first, ties by the lower vertex: maxima of the mean
/// geodesic distance to a dozen places spread over the surface (the paper's closing discussion names
/// such extremes as starts and ends). A limb that ends in a boundary has no tip.
/// Throws: Cancelled.
std::vector<Tip> find_tips(const TriangleMesh& mesh, RunContext* run = nullptr);

}  // namespace meshknit
