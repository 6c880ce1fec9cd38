#include <Eigen/SparseCholesky>
#include <algorithm>
#include <cmath>
#include <string>

#include "meshknit/core/error.h"
#include "meshknit/surface/disjoint_sets.h"
#include "meshknit/time_field/field_weights.h"
#include "meshknit/time_field/time_field.h"

namespace meshknit {
namespace {

using Matrix = Eigen::SparseMatrix<double>;
// The rows come in a good order already.
using Factor = Eigen::SimplicialLDLT<Matrix, Eigen::Lower, Eigen::NaturalOrdering<int>>;

// Far from every constraint (the end of a long tentacle) a harmonic field is constant up to
// rounding, and rounding has peaks and valleys. On a grid a thousand times coarser than
// rounding such a place is one flat spot. Rounding to a grid keeps order, so it makes no new
// extrema.
constexpr double kTimeGrid = 1.0 / (1LL << 40);

// The grid point nearest to a time, but never across a constraint's time.
double snapped(double time, const std::vector<double>& sorted_times) {
  time = std::clamp(time, sorted_times.front(), sorted_times.back());
  const auto above = std::lower_bound(sorted_times.begin(), sorted_times.end(), time);
  if (*above == time) return time;
  return std::clamp(kTimeGrid * std::round(time / kTimeGrid), *(above - 1), *above);
}

// Otherwise the system has no single answer, and the factorisation does not reliably say so.
void require_connected(const std::vector<EdgeWeight>& weights, const std::vector<int>& chain) {
  DisjointSets parts(chain.size());
  for (const EdgeWeight& w : weights) parts.unite(w.a, w.b);
  std::vector<bool> held(chain.size(), false);
  for (std::size_t v = 0; v < chain.size(); ++v)
    if (chain[v] >= 0) held[parts.root(static_cast<int>(v))] = true;
  for (std::size_t v = 0; v < chain.size(); ++v)
    if (!held[parts.root(static_cast<int>(v))])
      throw InvalidInput("time field: no edges lead from vertex " + std::to_string(v) +
                         " to any constraint");
}

}  // namespace

struct TimeFieldSolver::Impl {
  std::vector<int> chain;  // of a constrained vertex; -1: free
  std::vector<int> row;    // of a free vertex in the system; -1: constrained
  std::size_t chains = 0;
  Matrix pull;  // free vertices x chains: how chains pull their neighbours
  Factor factor;

  void constrain(std::size_t vertices, const std::vector<std::vector<int>>& constrained);
  void factorise(const std::vector<EdgeWeight>& weights, int free_vertices);
};

void TimeFieldSolver::Impl::constrain(std::size_t vertices,
                                      const std::vector<std::vector<int>>& constrained) {
  chains = constrained.size();
  chain.assign(vertices, -1);
  bool any = false;
  for (std::size_t c = 0; c < chains; ++c)
    for (const int v : constrained[c]) {
      if (v < 0 || v >= static_cast<int>(vertices))
        throw InvalidInput("time field: constraint " + std::to_string(c) + " names vertex " +
                           std::to_string(v) + ", which the mesh does not have");
      if (chain[v] >= 0 && chain[v] != static_cast<int>(c))
        throw InvalidInput("time field: vertex " + std::to_string(v) + " is in constraints " +
                           std::to_string(chain[v]) + " and " + std::to_string(c));
      chain[v] = static_cast<int>(c);
      any = true;
    }
  if (!any) throw InvalidInput("time field: there are no constraints to interpolate");
}

void TimeFieldSolver::Impl::factorise(const std::vector<EdgeWeight>& weights,
                                      int free_vertices) {
  std::vector<Eigen::Triplet<double>> system, pulls;
  system.reserve(3 * weights.size());
  for (const EdgeWeight& w : weights) {
    const std::array<int, 2> ends = {w.a, w.b};
    for (int i = 0; i < 2; ++i) {
      const int here = row[ends[i]], there = row[ends[1 - i]];
      if (here < 0) continue;
      system.emplace_back(here, here, w.weight);
      // SimplicialLDLT reads the lower triangle only.
      if (there >= 0 && there < here) system.emplace_back(here, there, -w.weight);
      if (there < 0) pulls.emplace_back(here, chain[ends[1 - i]], w.weight);
    }
  }
  Matrix matrix(free_vertices, free_vertices);
  matrix.setFromTriplets(system.begin(), system.end());
  pull.resize(free_vertices, static_cast<Eigen::Index>(chains));
  pull.setFromTriplets(pulls.begin(), pulls.end());
  if (free_vertices == 0) return;
  factor.compute(matrix);
  if (factor.info() != Eigen::Success)
    throw BrokenPromise("time field: a Laplacian with positive weights could not be factored");
}

TimeFieldSolver::TimeFieldSolver(const Surface& surface,
                                 const std::vector<std::vector<int>>& constrained,
                                 LaplacianKind kind)
    : TimeFieldSolver(field_weights(surface, kind), constrained) {}

TimeFieldSolver::TimeFieldSolver(const FieldWeights& weights,
                                 const std::vector<std::vector<int>>& constrained)
    : impl_(std::make_unique<Impl>()) {
  const std::vector<int>& order = weights.elimination_order;
  impl_->constrain(order.size(), constrained);
  require_connected(weights.weights, impl_->chain);
  int free_vertices = 0;
  impl_->row.assign(order.size(), -1);
  for (const int v : order)
    if (impl_->chain[v] < 0) impl_->row[v] = free_vertices++;
  impl_->factorise(weights.weights, free_vertices);
}

TimeFieldSolver::~TimeFieldSolver() = default;
TimeFieldSolver::TimeFieldSolver(TimeFieldSolver&&) noexcept = default;
TimeFieldSolver& TimeFieldSolver::operator=(TimeFieldSolver&&) noexcept = default;

std::vector<double> TimeFieldSolver::solve(const std::vector<double>& times) const {
  if (times.size() != impl_->chains)
    throw InvalidInput("time field: one time is needed for every constraint");
  for (const double t : times)
    if (!std::isfinite(t))
      throw InvalidInput("time field: a constraint's time is not a number");
  Eigen::VectorXd free;
  if (impl_->pull.rows() > 0) {
    const Eigen::Map<const Eigen::VectorXd> chain_times(
        times.data(), static_cast<Eigen::Index>(times.size()));
    free = impl_->factor.solve(impl_->pull * chain_times);
  }
  std::vector<double> sorted = times;
  std::sort(sorted.begin(), sorted.end());
  std::vector<double> result;
  for (std::size_t v = 0; v < impl_->row.size(); ++v)
    result.push_back(impl_->row[v] < 0 ? times[impl_->chain[v]]
                                       : snapped(free[impl_->row[v]], sorted));
  return result;
}

}  // namespace meshknit
