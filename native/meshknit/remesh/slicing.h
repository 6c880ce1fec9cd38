#pragma once

#include <vector>

#include "meshknit/remesh/front.h"
#include "meshknit/remesh/geodesic_band.h"
#include "meshknit/remesh/row_level.h"

namespace meshknit {

/// A candidate for the next row: a level set of the distance from the active cycle
/// (paper, 3.2.2), with what is known at its crossings.
struct NextCycle {
  Cycle cycle;
  std::vector<double> time;  ///< knitting time
  std::vector<int> source;   ///< which of the active cycles is nearest
  std::vector<double> foot;  ///< nearest place on it
  std::vector<double>
      gap;  ///< distance from the active cycle, mm: the level, but at the end of the tube
};

/// Finds level sets in a band. Keeps scratch memory between rows.
class Slicer {
 public:
  Slicer(const PeelState& state, const KnitLimits& limits);

  /// All components of the border of what lies below the level and may be knit in this step,
  /// longest first.
  /// Requires: band.measure(actives, limit) with a limit of at least the row's height.
  std::vector<NextCycle> slice(const GeodesicBand& band,
                               const std::vector<const Cycle*>& actives, const RowLevel& level);

 private:
  std::vector<int> crossed_edges(const GeodesicBand& band, const RowLevel& level) const;
  void add_crossing(const GeodesicBand& band, const std::vector<const Cycle*>& actives,
                    const RowLevel& level, int halfedge, NextCycle& next) const;
  bool below(const GeodesicBand& band, const RowLevel& level, int vertex) const {
    return state_.knitted[vertex] || limits_.must_knit(vertex) ||
           (limits_.may_knit(vertex) &&
            band.distance(vertex) < level.height(vertex, band.distance(vertex)));
  }

  const PeelState& state_;
  const KnitLimits& limits_;
  std::vector<char> seen_;  // per edge
};

}  // namespace meshknit
