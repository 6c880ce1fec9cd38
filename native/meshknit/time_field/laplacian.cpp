#include "meshknit/time_field/laplacian.h"

#include <algorithm>
#include <cmath>
#include <tuple>

#include "meshknit/time_field/intrinsic_delaunay.h"

namespace meshknit {
namespace {

// Lowest weights, of the mean size. A Delaunay weight below its floor is rounding (or the outer
// side of an obtuse triangle on the boundary); a plain cotangent below its floor is an obtuse
// pair of triangles.
constexpr double kDelaunayFloor = 1e-9;
constexpr double kClampFloor = 1e-3;

std::vector<EdgeWeight> cotangent_weights(const IntrinsicTriangles& triangles) {
  std::vector<EdgeWeight> parts;
  parts.reserve(3 * triangles.corners.size());
  for (std::size_t f = 0; f < triangles.corners.size(); ++f)
    for (int k = 0; k < 3; ++k) {
      const int a = triangles.corners[f][k], b = triangles.corners[f][(k + 1) % 3];
      // A side from a vertex round to itself pulls nothing.
      if (a != b)
        parts.push_back({std::min(a, b), std::max(a, b),
                         0.5 * cotangent_opposite(triangles.lengths[f], k)});
    }
  // A stable sort keeps the order of the summands, and with it the sums.
  std::stable_sort(parts.begin(), parts.end(), [](const EdgeWeight& x, const EdgeWeight& y) {
    return std::tie(x.a, x.b) < std::tie(y.a, y.b);
  });
  std::vector<EdgeWeight> weights;
  for (const EdgeWeight& part : parts) {
    if (!weights.empty() && weights.back().a == part.a && weights.back().b == part.b)
      weights.back().weight += part.weight;
    else
      weights.push_back(part);
  }
  return weights;
}

void raise_to(double fraction_of_mean, std::vector<EdgeWeight>& weights) {
  double sum = 0.0;
  for (const EdgeWeight& w : weights) sum += std::abs(w.weight);
  const double floor = fraction_of_mean * sum / static_cast<double>(weights.size());
  for (EdgeWeight& w : weights) w.weight = std::max(w.weight, floor);
}

std::vector<EdgeWeight> uniform_weights(const TriangleMesh& mesh) {
  std::vector<EdgeWeight> weights;
  for (const auto e : mesh.edges()) {
    const auto half = mesh.halfedge_handle(e, 0);
    const int a = mesh.from_vertex_handle(half).idx(), b = mesh.to_vertex_handle(half).idx();
    weights.push_back({std::min(a, b), std::max(a, b), 1.0});
  }
  std::sort(weights.begin(), weights.end(), [](const EdgeWeight& x, const EdgeWeight& y) {
    return std::tie(x.a, x.b) < std::tie(y.a, y.b);
  });
  return weights;
}

}  // namespace

std::vector<EdgeWeight> laplacian_weights(const TriangleMesh& mesh, LaplacianKind kind) {
  if (kind == LaplacianKind::uniform) return uniform_weights(mesh);
  const bool delaunay = kind == LaplacianKind::intrinsic_delaunay;
  std::vector<EdgeWeight> weights =
      cotangent_weights(delaunay ? intrinsic_delaunay(mesh) : side_lengths(mesh));
  if (!weights.empty()) raise_to(delaunay ? kDelaunayFloor : kClampFloor, weights);
  return weights;
}

}  // namespace meshknit
