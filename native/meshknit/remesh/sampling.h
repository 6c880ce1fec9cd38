#pragma once

#include <vector>

#include "meshknit/remesh/active_cycle.h"
#include "meshknit/remesh/slicing.h"

namespace meshknit {

/// Where a node's links should lead to.
struct NodeImage {
  double place = 0.0;  ///< its nearest place on the next cycle, mm along it
  double off = 0.0;    ///< how far aside the foot of that place is, mm along the active cycle
};

/// The images of the nodes of active cycle number `source`: the inverse of the next cycle's `foot`.
std::vector<NodeImage> images_on_next(const ActiveCycle& active, int source,
                                      const NextCycle& next);

/// Places of the next row's nodes along the next cycle: as many as its length asks for, clamped
/// so that linking is always possible (paper, 3.2.3), evenly spread, and turned so that they
/// face the active nodes. At least `fewest` where linking allows, and a multiple of `unit`.
std::vector<double> sample_next_row(const ActiveCycle& active, const NextCycle& next,
                                    const std::vector<NodeImage>& images, double stitch_width,
                                    int fewest, int unit = 1);

}  // namespace meshknit
