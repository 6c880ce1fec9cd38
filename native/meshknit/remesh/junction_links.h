#pragma once

#include <vector>

#include "meshknit/remesh/active_cycle.h"
#include "meshknit/remesh/slicing.h"

namespace meshknit {

/// Where a row and the nodes that it is linked to lie on each other.
struct NodeImage {
  double place = 0.0;  ///< nearest place on the next cycle, mm along it
  double off = 0.0;    ///< how far from the node its foot is, mm along the active cycle
};

/// The nearest place of each node of active cycle `source` on a next cycle.
std::vector<NodeImage> images_across(const ActiveCycle& active, int source,
                                     const NextCycle& next);

/// A stretch round a loop: `count` elements from `first` on.
struct Stretch {
  int first = 0, count = 0;
};

/// The stretch that holds as much wanted and as little unwanted as possible (weights positive and
/// negative), with at least `fewest` elements in it and as many outside.
/// Requires: at least 2 * fewest weights.
Stretch best_stretch(const std::vector<double>& weights, int fewest);

}  // namespace meshknit
