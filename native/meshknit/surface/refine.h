#pragma once

#include <vector>

#include "meshknit/core/run_context.h"
#include "meshknit/surface/triangle_mesh.h"

namespace meshknit {

/// A finer mesh of the same shape, with a value per vertex interpolated linearly.
struct RefinedMesh {
  TriangleMesh mesh;
  std::vector<double> value;
  std::vector<int> source_face;  ///< face -> face of the mesh that was refined
};

/// Splits the longest edges first until none is longer than max_edge (mm), and every inner edge
/// between two boundary vertices. The first vertices are those of the input. Deterministic; the
/// geometry is unchanged.
/// Requires: manifold mesh with finite positions. The result has about area / max_edge^2 faces
/// or more.
/// Throws: InvalidInput if there is not one value a vertex or max_edge is not positive; Cancelled.
/// Ensures: a face has three boundary vertices only if all its edges are boundary edges.
RefinedMesh refine_mesh(const TriangleMesh& mesh, const std::vector<double>& value,
                        double max_edge, RunContext* run = nullptr);

}  // namespace meshknit
