#pragma once

#include "meshknit/surface/blobs.h"
#include "meshknit/surface/triangle_mesh.h"

namespace meshknit {

/// A closed mesh by arrays.
struct BlobMesh {
  VertexArray vertices;
  FaceArray faces;
};

/// The surface of a body on a cubic lattice, each cube cut into the six tetrahedra round one
/// diagonal. Vertices lie on lattice edges, near the surface but never nearer than a twentieth of
/// the edge to its ends, so that no face has zero area; faces point out.
/// Details thinner than `spacing` (mm) may be lost.
/// Throws: InvalidInput if the lattice would have more than 2^26 points or spacing is not positive.
/// Ensures: every edge has two faces and the faces round every vertex form one fan.
BlobMesh march_tetrahedra(const Blobs& blobs, double spacing);

}  // namespace meshknit
