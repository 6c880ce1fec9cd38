#pragma once

#include <vector>

#include "meshknit/surface/surface.h"
#include "meshknit/time_field/laplacian.h"

namespace meshknit {

/// What the harmonic fields of one surface share, wherever their constraints lie. Kept while chains
/// are drawn, so that a new chain costs a factorisation and nothing else.
struct FieldWeights {
  std::vector<EdgeWeight> weights;
  /// Mesh vertices in an order that keeps factors sparse (minimum degree). Left-out vertices spoil
  /// it little: what is left of an elimination order is one of the remaining ones.
  std::vector<int> elimination_order;
};

FieldWeights field_weights(const Surface& surface,
                           LaplacianKind kind = LaplacianKind::intrinsic_delaunay);

}  // namespace meshknit
