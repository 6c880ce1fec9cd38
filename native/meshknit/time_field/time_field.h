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
  intrinsic_delaunay,  ///< cotangent weights on the intrinsic Delaunay triangulation: positive
                       ///< and shape-true
  clamped_cotangent,   ///< cotangent weights raised to a small positive value
  uniform
};

struct FieldWeights;

/// Harmonic interpolation of constraints (paper, 3.1). All weights are positive, so every free
/// value is an average of its neighbours and extrema lie on constraints only. Keeps its
/// factorisation: changed times cost one back-solve, changed places a new solver.
class TimeFieldSolver {
 public:
  /// Throws: InvalidInput for a vertex that is not in the mesh, no constraints at all, a vertex
  /// in two constraints (use check_constraints first to get a message for people), or a piece
  /// of the mesh without any constraint.
  TimeFieldSolver(const Surface& surface, const std::vector<std::vector<int>>& constrained,
                  LaplacianKind kind = LaplacianKind::intrinsic_delaunay);
  /// The same for a surface's field_weights(); the fields are equal.
  TimeFieldSolver(const FieldWeights& weights,
                  const std::vector<std::vector<int>>& constrained);
  ~TimeFieldSolver();
  TimeFieldSolver(TimeFieldSolver&&) noexcept;
  TimeFieldSolver& operator=(TimeFieldSolver&&) noexcept;

  /// One time per chain given to the constructor -> one time per mesh vertex: the chains' own
  /// exactly, all others within the range of the given ones and rounded to 2^-40.
  /// Throws: InvalidInput if there is not one finite time a chain.
  std::vector<double> solve(const std::vector<double>& times) const;

 private:
  struct Impl;
  std::unique_ptr<Impl> impl_;
};

/// Problems of a set of constraints: "time-out-of-range" (outside [-1, 1]), "empty-constraint",
/// "boundary-without-time" (none, or on a part only), "boundary-with-two-times",
/// "contradictory-times" (a vertex elsewhere to which two constraints give different times),
/// "all-times-equal". They name vertices of the input arrays and boundaries.
/// Throws: InvalidInput for a vertex that is not in the mesh.
Problems check_constraints(const Surface& surface,
                           const std::vector<TimeConstraint>& constraints);

/// What a field is made of: critical points, and the count that topology asks for.
///
/// Neighbouring vertices with the same time are one spot, and a boundary with one time is a
/// spot with its opening filled. A spot is an extremum if no neighbour is later, or none is
/// earlier; otherwise the signs round it change 2k times, and it is a saddle of multiplicity
/// k-1 (for a spot with holes, one more for each). A boundary with both earlier and later
/// neighbours, which is neither start nor end, counts k. With these rules `saddles` equals
/// `expected_saddles` whenever boundaries are constant and there are no false extrema.
struct TimeFieldCheck {
  Problems problems;
  int extrema = 0;  ///< false extrema: local minima or maxima inside, or on a boundary that is
                    ///< not constant
  int saddles = 0;  ///< with multiplicity
  int expected_saddles = 0;  ///< 2g - 2 + b
};

/// Whether a field can guide the knitting (paper, section 2.2 and 3). Errors:
/// "time-not-finite", "boundary-not-constant" (beyond 1e-6 of the field's range),
/// "false-extremum", "boundary-in-passing" (neither start nor end), "no-start", "no-end",
/// "time-stands-still" (everywhere; a warning if on more than a hundredth of the area). They
/// name vertices and faces of the input arrays and boundaries.
/// Throws: InvalidInput if there is not one time a vertex.
TimeFieldCheck check_time_field(const Surface& surface, const std::vector<double>& time);

/// From constraints to a checked field: check_constraints, solve, check_time_field, falling
/// back to the clamped Laplacian if the first field fails its check. A vertex that several
/// constraints give the same time is fine.
/// Throws: NotKnittable with the problems found.
struct TimeField {
  std::vector<double> time;  ///< per mesh vertex
  TimeFieldCheck check;
};
TimeField solve_time_field(const Surface& surface,
                           const std::vector<TimeConstraint>& constraints);

}  // namespace meshknit
