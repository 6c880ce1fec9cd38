#pragma once

#include <vector>

#include "meshknit/surface/blobs.h"
#include "meshknit/surface/example_shapes.h"
#include "meshknit/surface/marching_tetrahedra.h"
#include "meshknit/surface/rim_cuts.h"

namespace meshknit {

/// The surface of a body as an even triangle mesh: closed but for the flat rims where its limbs
/// are cut. Edges are about `edge_length` (mm) long; details should be twice as thick.
/// Throws: InvalidInput if nothing or everything lies beyond a cut, or edge_length is not
/// positive or far too small for the body.
/// Ensures: manifold and oriented outward; make_surface finds nothing to mend.
BlobMesh mesh_of_blobs(const Blobs& blobs, const std::vector<RimCut>& cuts, double edge_length);

/// Where a limb's last piece ends: a flat rim across it, in the middle of its round end.
/// Requires: at least two stops.
RimCut end_of(const Limb& limb);

/// A rim and the time when it is knit.
struct TimedRim {
  RimCut cut;
  double time = 0.0;
};

/// The same mesh as an example, with its rims' times in their order.
ExampleShape shape_of_blobs(const Blobs& blobs, const std::vector<TimedRim>& rims,
                            double edge_length);

}  // namespace meshknit
