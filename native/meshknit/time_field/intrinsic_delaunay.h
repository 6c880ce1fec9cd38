#pragma once

#include <array>
#include <vector>

#include "meshknit/surface/triangle_mesh.h"

namespace meshknit {

/// Triangles known by their side lengths only. Side k joins corner k to the next corner.
struct IntrinsicTriangles {
  std::vector<std::array<int, 3>> corners;     ///< mesh vertices
  std::vector<std::array<double, 3>> lengths;  ///< mm
};

/// The mesh's own triangles, by lengths.
IntrinsicTriangles side_lengths(const TriangleMesh& mesh);

/// The intrinsic Delaunay triangulation of the surface: same vertices, geodesic sides, and
/// across every inner side the opposite angles sum to at most pi, so that cotangent weights are
/// not negative. By edge flips on lengths alone (Bobenko and Springborn 2007, "A discrete
/// Laplace-Beltrami operator for simplicial surfaces"). Two triangles may share more than one
/// side and a side may return to its own vertex.
/// Requires: manifold mesh, no zero-area faces. Thin triangles are welcome.
IntrinsicTriangles intrinsic_delaunay(const TriangleMesh& mesh);

/// Cotangent of the angle opposite to side k of a triangle with these sides.
double cotangent_opposite(const std::array<double, 3>& lengths, int k);

}  // namespace meshknit
