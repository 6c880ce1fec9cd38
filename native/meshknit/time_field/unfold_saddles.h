#pragma once

#include <vector>

#include "meshknit/surface/triangle_mesh.h"

namespace meshknit {

/// Turns saddles where three or more ways meet in one vertex into simple ones, by lowering the time
/// of a few neighbours to just below the vertex's own: "a perturbation of the input knitting time
/// function" (paper, appendix A). What cannot be unfolded without making a false extremum stays.
/// Returns how many saddles were unfolded.
int unfold_saddles(const TriangleMesh& mesh, std::vector<double>& time);

}  // namespace meshknit
