#pragma once

#include <vector>

#include "meshknit/surface/triangle_mesh.h"
#include "meshknit/time_field/time_field.h"

namespace meshknit {

/// How strongly two vertices pull each other's time together.
struct EdgeWeight {
  int a = 0, b = 0;  ///< mesh vertices, a < b
  double weight = 0.0;
};

/// The Laplacian's off-diagonal weights, one entry a pair, in ascending order of (a, b).
/// Ensures: every weight is positive, so harmonic values are averages of their neighbours.
std::vector<EdgeWeight> laplacian_weights(const TriangleMesh& mesh, LaplacianKind kind);

}  // namespace meshknit
