#pragma once

#include <vector>

#include "meshknit/remesh/front.h"
#include "meshknit/remesh/geodesic_band.h"

namespace meshknit {

/// Chooses how far the next cycle lies from the active one. Far from the end that is 2 l_c;
/// over the last rows the remaining distance is shared out evenly, so that the last row, which
/// is the boundary itself, is no higher or lower than the others.
class RowHeights {
 public:
  /// `to_end`: distance of vertices to the boundary where knitting ends, infinite where it is
  /// far.
  RowHeights(std::vector<double> to_end, double row_height)
      : to_end_(std::move(to_end)), row_height_(row_height) {}

  /// Rows over which the rest is shared out.
  static constexpr int shared_rows = 10;

  struct Next {
    double height;  ///< mm
    bool last;      ///< the next row is the boundary
  };
  Next next(const PeelState& state, const Cycle& active) const;

 private:
  std::vector<double> to_end_;
  double row_height_;
};

}  // namespace meshknit
