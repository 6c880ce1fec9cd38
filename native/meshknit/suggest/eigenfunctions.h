#pragma once

#include <vector>

#include "meshknit/core/run_context.h"
#include "meshknit/surface/triangle_mesh.h"

namespace meshknit {

/// The lowest eigenfunctions of the surface's Laplacian after the constant one: the Fiedler vector and
/// the next ones, which order a shape from one of its ends to the other (the paper's closing
/// discussion, after Levy and Zhang 2010). One value a vertex, `count` lists, lowest first, each of
/// mean square 1 and with its first largest value positive. Inverse iteration of all at once; nearly
/// equal eigenvalues may come mixed.
/// Throws: Cancelled.
std::vector<std::vector<double>> low_eigenfunctions(const TriangleMesh& mesh, int count,
                                                    RunContext* run = nullptr);

}  // namespace meshknit
