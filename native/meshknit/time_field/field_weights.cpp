#include "meshknit/time_field/field_weights.h"

#include <Eigen/OrderingMethods>
#include <Eigen/SparseCore>

namespace meshknit {
namespace {

std::vector<int> minimum_degree_order(const std::vector<EdgeWeight>& weights, int vertices) {
  std::vector<Eigen::Triplet<double>> entries;
  entries.reserve(weights.size() + vertices);
  for (int v = 0; v < vertices; ++v) entries.emplace_back(v, v, 1.0);
  for (const EdgeWeight& w : weights) entries.emplace_back(w.b, w.a, 1.0);
  Eigen::SparseMatrix<double> pattern(vertices, vertices);
  pattern.setFromTriplets(entries.begin(), entries.end());
  Eigen::PermutationMatrix<Eigen::Dynamic, Eigen::Dynamic, int> order;
  Eigen::AMDOrdering<int>()(pattern.selfadjointView<Eigen::Lower>(), order);
  return {order.indices().data(), order.indices().data() + order.indices().size()};
}

}  // namespace

FieldWeights field_weights(const Surface& surface, LaplacianKind kind) {
  FieldWeights result;
  result.weights = laplacian_weights(surface.mesh, kind);
  result.elimination_order =
      minimum_degree_order(result.weights, static_cast<int>(surface.mesh.n_vertices()));
  return result;
}

}  // namespace meshknit
