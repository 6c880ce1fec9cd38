#pragma once

#include <optional>
#include <vector>

#include "meshknit/remesh/front.h"
#include "meshknit/remesh/geodesic_band.h"
#include "meshknit/remesh/row_level.h"

namespace meshknit {

/// The part of a band that an accepted row covers: between two walls that lead from the active
/// cycle (distance 0) up to the next cycle. All four are places along the active cycle.
struct TrimRegion {
  double begin_below, begin_above;
  double end_below, end_above;
};

/// Vertices of the fine mesh: pockets of a few stitches, which are flaws of a row, and the largest
/// part of an object that is knitted over where no row can reach into it.
inline constexpr std::size_t small_pocket = 250, large_pocket = 400;

/// Marks the surface between the active cycle and an accepted row as knitted, and finds the new
/// active cycle (paper, 3.2.4) by labels: the mesh is not cut.
class Trimmer {
 public:
  Trimmer(PeelState& state, const KnitLimits& limits);

  /// `regions` empty: the whole band up to `level`, whose level set is `next`. Pockets that a
  /// row closes off are knitted over if they have no more vertices than `largest_pocket`. No cycle if what is
  /// left open falls apart; then nothing has changed.
  std::optional<Cycle> trim(const GeodesicBand& band, const Cycle& active, const Cycle& next,
                            const RowLevel& level, const std::vector<TrimRegion>& regions,
                            std::size_t largest_pocket = small_pocket);

  /// Vertices that the last trim() knitted.
  int newly_knitted() const { return newly_knitted_; }

 private:
  std::vector<int> front_edges(const Cycle& active, const std::vector<int>& knitted_now);
  std::vector<Cycle> walk(const std::vector<int>& crossed);
  bool close_pocket(const Cycle& island, std::size_t largest_pocket,
                    std::vector<int>& knitted_now);
  bool reopen_island(const Cycle& island, const std::vector<int>& all_now);

  PeelState& state_;
  const KnitLimits& limits_;
  std::vector<char> seen_;  // per edge
  int newly_knitted_ = 0;
};

}  // namespace meshknit
