#pragma once

#include <vector>

namespace meshknit {

/// A stretch round a loop: `count` elements from `first` on.
struct Stretch {
  int first = 0, count = 0;
};

/// The stretch that holds as much wanted and as little unwanted as possible (weights positive and
/// negative), with at least `fewest` elements in it and as many outside.
/// Requires: at least 2 * fewest weights.
Stretch best_stretch(const std::vector<double>& weights, int fewest);

}  // namespace meshknit
