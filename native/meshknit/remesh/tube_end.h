#pragma once

#include <vector>

#include "meshknit/remesh/front.h"
#include "meshknit/remesh/sweep_plan.h"

namespace meshknit {

/// How far it is from the active cycle to where its tube ends, mm. Very large where that is more than
/// SweepPlan's planned_rows.
struct RestOfTube {
  double least = 0.0, mean = 0.0, most = 0.0;
  std::vector<double> at_crossing;

  /// The last rows share out what is left, so that none is squeezed or stretched: `rows` of this
  /// height, at least one. No rows: the end is far, and rows are as high as they should be.
  int rows = 0;
  double height = 0.0;

  /// So near that rows follow the distance to the end instead of time: places where the end is more
  /// than `rows` rows away (from half a row on) get short rows first (the paper's "distortion of
  /// the shape close to the boundaries").
  bool near = false;
};

/// Requires: the active cycle of this arc of the plan.
RestOfTube rest_of_tube(const PeelState& state, const SweepPlan& plan, int arc,
                        const Cycle& active, double row_height);

}  // namespace meshknit
