#include "meshknit/time_field/time_field.h"

#include "meshknit/core/error.h"

namespace meshknit {

TimeField solve_time_field(const Surface& surface,
                           const std::vector<TimeConstraint>& constraints) {
  Problems problems = check_constraints(surface, constraints);
  if (has_errors(problems)) throw NotKnittable(std::move(problems));

  // Constraints with one time may share vertices; the solver wants each in one chain.
  std::vector<bool> taken(surface.mesh.n_vertices(), false);
  std::vector<std::vector<int>> chains;
  std::vector<double> times;
  for (const TimeConstraint& constraint : constraints) {
    chains.emplace_back();
    times.push_back(constraint.time);
    for (const int v : constraint.vertices) {
      if (!taken[v]) chains.back().push_back(v);
      taken[v] = true;
    }
  }

  // The Delaunay field is true to the shape, and has no extrema among *its* neighbours; on thin
  // triangles the mesh's neighbours are others, and then the clamped weights, which are the
  // mesh's own, may be needed.
  TimeField field;
  for (const LaplacianKind kind :
       {LaplacianKind::intrinsic_delaunay, LaplacianKind::clamped_cotangent}) {
    field.time = TimeFieldSolver(surface, chains, kind).solve(times);
    field.check = check_time_field(surface, field.time);
    if (!has_errors(field.check.problems)) return field;
  }
  throw NotKnittable(std::move(field.check.problems));
}

}  // namespace meshknit
