#pragma once

#include <vector>

#include "meshknit/remesh/active_cycle.h"
#include "meshknit/remesh/slicing.h"

namespace meshknit {

/// Where on the next cycle the nearest point of each active node is: the inverse of the next
/// cycle's `foot`.
std::vector<double> images_on_next(const ActiveCycle& active, const NextCycle& next);

/// Places of the next row's nodes along the next cycle: as many as its length asks for, clamped
/// so that linking is always possible (paper, 3.2.3), evenly spread, and turned so that they
/// face the active nodes. At least `fewest` where linking allows.
std::vector<double> sample_next_row(const ActiveCycle& active, const NextCycle& next,
                                    const std::vector<double>& images, double stitch_width,
                                    int fewest);

}  // namespace meshknit
