#pragma once

#include <vector>

#include "meshknit/remesh/front.h"
#include "meshknit/remesh/geodesic_band.h"

namespace meshknit {

/// A candidate for the next row: a level set of the distance from the active cycle
/// (paper, 3.2.2), with what is known at its crossings.
struct NextCycle {
  Cycle cycle;
  std::vector<double> time;  ///< knitting time
  std::vector<double> foot;  ///< nearest place on the active cycle
  std::vector<double>
      gap;  ///< distance from the active cycle, mm: the level, but at the last boundary
};

/// Finds level sets in a band. Keeps scratch memory between rows.
class Slicer {
 public:
  /// `last` marks vertices that stay open to the end: those of the boundaries where knitting
  /// ends.
  Slicer(const PeelState& state, const std::vector<char>& last);

  /// All components of the level set at `level` mm that lie in the measured band, largest
  /// first.
  /// Requires: band.measure(active, limit) with a limit of at least the level.
  std::vector<NextCycle> slice(const GeodesicBand& band, const Cycle& active, double level);

 private:
  const PeelState& state_;
  const std::vector<char>& last_;
  std::vector<char> seen_;  // per edge
};

}  // namespace meshknit
