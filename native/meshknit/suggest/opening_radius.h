#pragma once

#include <vector>

#include "meshknit/surface/triangle_mesh.h"

namespace meshknit {

/// The smallest geodesic radius (mm) round a vertex whose rim holds a dozen stitches of this width, or
/// eight where the limb is no wider. 0 if there is none within `most` mm of the vertex and an eighth
/// of `area`.
double radius_for_opening(const TriangleMesh& mesh, int vertex, double most,
                          double stitch_width, double area);

/// Distance along the surface from a vertex (point_distance.h), mm.
std::vector<double> distance_to(const TriangleMesh& mesh, int vertex);

/// The vertex whose nearest one of these is furthest away; the lowest of equally far ones.
int furthest_vertex(const TriangleMesh& mesh, const std::vector<int>& from);

}  // namespace meshknit
