#pragma once

#include <algorithm>

#include "meshknit/remesh/sweep_plan.h"

namespace meshknit {

/// How high the next row stands above the active cycle: everywhere the same, or, near the end of a
/// tube, everywhere the same part of the way that is left.
class RowLevel {
 public:
  static RowLevel of_height(double height) { return RowLevel(height, 0, nullptr); }
  /// One of so many rows that are left, but no higher than `most`.
  static RowLevel part_of_rest(int rows, double most, const SweepPlan& plan) {
    return RowLevel(most, rows, &plan);
  }

  /// Height of the row at a vertex that lies this far from the active cycle, mm.
  double height(int vertex, double distance) const {
    return plan_ ? std::min(height_, (distance + plan_->to_end[vertex]) / rows_) : height_;
  }

 private:
  RowLevel(double height, int rows, const SweepPlan* plan)
      : height_(height), rows_(rows), plan_(plan) {}
  double height_;
  int rows_;
  const SweepPlan* plan_;
};

}  // namespace meshknit
