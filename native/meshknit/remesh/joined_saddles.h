#pragma once

#include <vector>

#include "meshknit/remesh/sweep_plan.h"

namespace meshknit {

/// Saddles between which no row fits become one: splits that follow each other up a tube, or merges,
/// with less than half a row from the first one's level to the last one's. Their junction then parts
/// the tube into three or more, or joins as many, in one row (paper, appendix A).
/// `apart`: fine vertices of saddles that stay as they are.
/// Requires: plan.reeb; plan.region with the arc or event of every vertex; plan.end_level per arc.
/// Ensures: the same of the smaller graph. What lay between joined saddles is the event's region.
void join_near_saddles(const PeelState& state, double row_height, const std::vector<int>& apart,
                       SweepPlan& plan);

}  // namespace meshknit
