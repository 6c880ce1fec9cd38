#pragma once

#include <memory>
#include <vector>

#include "meshknit/remesh/geodesic_band.h"
#include "meshknit/remesh/knit_limits.h"
#include "shapes.h"

namespace meshknit {

/// A tube that is being peeled by hand: its fine mesh, and the active cycle, which begins just
/// inside the start boundary.
struct PeeledSurface {
  explicit PeeledSurface(const TimedShape& shape, double longest_edge = 2.8);
  PeeledSurface(const PeeledSurface&) = delete;
  PeeledSurface& operator=(const PeeledSurface&) = delete;

  /// Peels this many whole rows of this height (mm) off, without regard to time.
  void peel(int rows, double height = 3.46);

  PeelState state;
  std::vector<int> source_face;  ///< face -> face of the shape's mesh
  SweepPlan plan;
  std::unique_ptr<KnitLimits> limits;
  Cycle active;
};

/// What is left open: Euler characteristic of the vertices that are not knitted with the edges
/// and faces among them. A tube that has lost whole rows has 0, one with a hole more has -1.
int open_characteristic(const PeelState& state);

}  // namespace meshknit
