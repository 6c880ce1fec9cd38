#pragma once

#include <vector>

#include "meshknit/surface/nearest_face.h"

namespace meshknit {

/// A piece of the input: what a face of a mesh that is being cut came from.
struct FaceOrigin {
  int face = -1;     ///< face of the mesh before refining and cutting
  int opening = -1;  ///< the opening that it is left out with
};

/// Splits faces round a place until none that comes within `reach` mm of it has an edge longer
/// than `max_edge` mm. Only faces that hang together with the place inside that ball are
/// wanted; others are split where it keeps triangles in shape. The surface stays where it is.
/// Source: longest-edge bisection, after Rivara 1984: no angle becomes less than half of the
/// least one there was.
void refine_near(TriangleMesh& mesh, std::vector<FaceOrigin>& origin, const SurfacePoint& place,
                 double reach, double max_edge);

}  // namespace meshknit
