#pragma once

#include <vector>

#include "meshknit/surface/nearest_face.h"

namespace meshknit {

/// Distance along the surface (mm) from a place on it to every vertex within `limit` mm;
/// infinite beyond.
///
/// Each triangle carries the distance over itself by unfolding the point source that its two
/// known corners see (after Novotni and Klein 2002), so a flat part is exact, however it is cut
/// into triangles. Where the surface bends, and behind a corner of a hole, the error falls with
/// the edges: it is below 2 % with edges of a sixth of the distance.
std::vector<double> distance_from(const TriangleMesh& mesh, const SurfacePoint& source,
                                  double limit);

/// Where on an edge of this length, whose ends have the distances `low` <= level <= `high`, the
/// distance is `level`: a fraction in [0, 1] from the low end. Exact where both ends see the
/// same source.
double level_crossing(double low, double high, double length, double level);

}  // namespace meshknit
