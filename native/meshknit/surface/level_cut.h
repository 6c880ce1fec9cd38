#pragma once

#include <vector>

#include "meshknit/surface/refine_near.h"

namespace meshknit {

/// Cuts the faces along the line where `distance` (one a vertex, infinite where unknown) is
/// `level`, so that every face lies on one side. A crossing within `snap` of an edge's length
/// from one of its ends goes through that vertex, so that no slivers arise. Vertices on the line
/// get exactly `level`; `distance` grows by the new ones.
void cut_along_level(TriangleMesh& mesh, std::vector<FaceOrigin>& origin,
                     std::vector<double>& distance, double level, double snap);

/// Length (mm) of the line where `distance` is `level`.
double line_length(const TriangleMesh& mesh, const std::vector<double>& distance, double level);

/// The faces within the line, after cut_along_level(), ascending: those with a vertex below
/// `level`, and those with all three on it that mostly have such neighbours.
std::vector<int> faces_within(const TriangleMesh& mesh, const std::vector<double>& distance,
                              double level);

}  // namespace meshknit
