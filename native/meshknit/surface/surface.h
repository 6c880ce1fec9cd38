#pragma once

#include <vector>

#include "meshknit/core/problem.h"
#include "meshknit/surface/triangle_mesh.h"

namespace meshknit {

/// A boundary loop: mesh vertices in order, with the surface on their left.
struct BoundaryLoop {
  std::vector<int> vertices;
  double length = 0.0;  ///< mm
};

/// A checked surface. If `problems` has no error the mesh is one connected, oriented, manifold
/// surface with at least two boundaries, without zero-area faces. Problems name vertices and
/// faces of the input arrays.
struct Surface {
  TriangleMesh mesh;
  std::vector<int> source_vertex;  ///< mesh vertex -> row of the input's vertices (the first of
                                   ///< doubled ones)
  std::vector<int>
      vertex_of_source;          ///< row of the input's vertices -> mesh vertex, -1 if unused
  std::vector<int> source_face;  ///< mesh face -> row of the input's faces
  std::vector<BoundaryLoop>
      boundaries;      ///< ordered by their smallest source vertex, which comes first in each
  int genus = 0;       ///< of all pieces together
  int components = 0;  ///< pieces that hang together across edges
  double area = 0.0;   ///< mm^2
  Problems problems;
};

struct SurfaceOptions {
  double stitch_width = 3.66;  ///< l_r, mm: a boundary must hold a row
  int fewest_stitches = 6;     ///< shortest row that a boundary may have
};

/// Arrays (mm) -> checked surface (what the paper asks of its input, section 3).
///
/// Mends what can be mended without changing the shape and says so in notes: "repeated-face",
/// "doubled-vertices" (see doubled_vertices.h), "unused-vertices", "flipped-faces", and
/// "zero-area-face" for faces that collapse because two of their corners are one vertex.
/// Errors: "empty-mesh", "not-finite", "zero-area-face" (height below 1e-9 of the longest
/// side), "nonmanifold-edge", "nonmanifold-vertex", "not-orientable", "several-components",
/// "too-few-boundaries", "short-boundary". With the last three `mesh` is there to look at, with
/// the others it is empty. Bad geometry never throws.
/// Throws: InvalidInput if a face names a vertex that is not there.
Surface make_surface(const VertexArray& vertices, const FaceArray& faces,
                     const SurfaceOptions& options = {});

}  // namespace meshknit
