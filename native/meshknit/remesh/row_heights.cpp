#include "meshknit/remesh/row_heights.h"

#include <algorithm>
#include <cmath>

namespace meshknit {

RowHeights::Next RowHeights::next(const PeelState& state, const Cycle& active) const {
  double sum = 0.0, weight = 0.0;
  const int n = active.size();
  for (int i = 0; i < n; ++i) {
    const EdgeCrossing& c = active.crossings[i];
    const double u = to_end_[state.from(c.halfedge)], w = to_end_[state.to(c.halfedge)];
    const double rest = u + c.t * (w - u);
    if (!std::isfinite(rest)) return {row_height_, false};
    const double share = active.arc[i + 1] - active.arc[i];
    sum += share * rest;
    weight += share;
  }
  const double rest = sum / weight;
  const double rows = std::max(1.0, std::round(rest / row_height_));
  if (rows > shared_rows) return {row_height_, false};
  return {rest / rows, rows <= 1.0};
}

}  // namespace meshknit
