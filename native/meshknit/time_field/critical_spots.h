#pragma once

#include <vector>

#include "meshknit/core/run_context.h"
#include "meshknit/surface/surface.h"

namespace meshknit {

/// Neighbouring vertices with one time, taken together (TimeFieldCheck says how a spot is
/// judged).
struct TimeSpot {
  std::vector<int> vertices;    ///< mesh vertices, ascending
  std::vector<int> boundaries;  ///< constant boundaries that belong to it
  bool on_varying_boundary = false;
  bool has_earlier = false, has_later = false;  ///< neighbours
  int sign_changes = 0;                         ///< between earlier and later, going round it
  int characteristic =
      0;  ///< Euler characteristic with the boundaries filled: 1 for a point or a disk

  bool is_extremum() const { return !(has_earlier && has_later); }
};

/// Spots without regard to boundaries, by their lowest vertex, and which one each vertex is in.
struct TimeSpots {
  std::vector<TimeSpot> spots;
  std::vector<int> spot_of;
};
/// Requires: a finite time per mesh vertex. Throws: Cancelled.
TimeSpots spots_of_mesh(const TriangleMesh& mesh, const std::vector<double>& time,
                        RunContext* run = nullptr);

/// All spots of a field, by their lowest vertex. `constant[b]`: boundary b has one time and is
/// filled.
/// Requires: a finite time per mesh vertex, the same on all vertices of a constant boundary.
/// Ensures: the sum of characteristic - sign_changes / 2 over all spots is 2 - 2g (Poincare and
/// Hopf) if all boundaries are constant.
std::vector<TimeSpot> time_spots(const Surface& surface, const std::vector<double>& time,
                                 const std::vector<bool>& constant);

}  // namespace meshknit
