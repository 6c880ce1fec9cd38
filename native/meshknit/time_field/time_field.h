#pragma once

#include <memory>
#include <string>
#include <vector>

#include "meshknit/core/problem.h"
#include "meshknit/surface/surface.h"

namespace meshknit {

/// A chain of mesh vertices (a boundary, or along edges) that is knit at one time.
struct TimeConstraint {
  std::vector<int> vertices;  ///< mesh vertices
  double time = 0.0;          ///< in [-1, 1]
};

/// How the time between constraints is interpolated.
enum class LaplacianKind {
  intrinsic_delaunay,  ///< cotangent weights on the intrinsic Delaunay triangulation: positive and shape-true
  clamped_cotangent,   ///< cotangent weights raised to a small positive value
  uniform
};

/// Harmonic interpolation of constraints (paper, 3.1). All weights are positive, so every free value is an
/// average of its neighbours and extrema lie on constraints only. Keeps its factorisation: changed times cost
/// one back-solve, changed places a new solver.
class TimeFieldSolver {
 public:
  /// Throws: InvalidInput for a vertex that is not in the mesh, no constraints at all, or a vertex in two constraints (use
  /// check_constraints first to get a message for people).
  TimeFieldSolver(const Surface& surface, const std::vector<std::vector<int>>& constrained,
                  LaplacianKind kind = LaplacianKind::intrinsic_delaunay);
  ~TimeFieldSolver();
  TimeFieldSolver(TimeFieldSolver&&) noexcept;
  TimeFieldSolver& operator=(TimeFieldSolver&&) noexcept;

  /// One time per chain given to the constructor -> one time per mesh vertex.
  std::vector<double> solve(const std::vector<double>& times) const;

 private:
  struct Impl;
  std::unique_ptr<Impl> impl_;
};

/// Problems of a set of constraints: times outside [-1, 1], boundaries without a time ("boundary-without-time") or with two
/// ("boundary-with-two-times"), vertices that two constraints give different times ("contradictory-times"), all times equal.
Problems check_constraints(const Surface& surface, const std::vector<TimeConstraint>& constraints);

/// What a field is made of: critical points away from the boundary and the count that topology asks for.
struct TimeFieldCheck {
  Problems problems;
  int extrema = 0;          ///< false extrema: strict local minima or maxima inside, or on a boundary that is not constant
  int saddles = 0;          ///< with multiplicity
  int expected_saddles = 0; ///< 2g - 2 + b
};

/// Extrema only on boundaries, constant on each, both an early and a late boundary, saddle count 2g-2+b, no NaN. Ties are
/// broken by vertex index. Violations name vertices (of the input arrays) and boundaries.
TimeFieldCheck check_time_field(const Surface& surface, const std::vector<double>& time);

/// From constraints to a checked field: check_constraints, solve, check_time_field, falling back to the clamped
/// Laplacian if the first field fails its check. Vertices inside chains that end up outside any constraint are free.
/// Throws: NotKnittable with the problems found.
struct TimeField {
  std::vector<double> time;  ///< per mesh vertex
  TimeFieldCheck check;
};
TimeField solve_time_field(const Surface& surface, const std::vector<TimeConstraint>& constraints);

}  // namespace meshknit
