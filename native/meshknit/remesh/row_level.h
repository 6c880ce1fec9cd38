#pragma once

#include <algorithm>
#include <vector>

#include "meshknit/remesh/sweep_plan.h"

namespace meshknit {

/// How high the next row stands above the active cycle: everywhere the same, or, near the end of a
/// tube, everywhere the same part of the way that is left; and nowhere later than a given time.
class RowLevel {
 public:
  static RowLevel of_height(double height) { return RowLevel(height); }
  /// One of so many rows that are left, but no higher than `most`.
  static RowLevel part_of_rest(int rows, double most, const SweepPlan& plan) {
    RowLevel level(most);
    level.rows_ = rows;
    level.to_end_ = &plan.to_end;
    return level;
  }
  RowLevel not_later_than(double time, const PeelState& state) const {
    RowLevel level = *this;
    level.latest_ = time;
    level.time_ = &state.time;
    return level;
  }

  /// Height of the row at a vertex that lies this far from the active cycle, mm.
  double height(int vertex, double distance) const {
    if (time_ && (*time_)[vertex] > latest_) return 0.0;
    return to_end_ ? std::min(height_, (distance + (*to_end_)[vertex]) / rows_) : height_;
  }

 private:
  explicit RowLevel(double height) : height_(height) {}
  double height_;
  int rows_ = 1;
  double latest_ = 0.0;
  const std::vector<double>* to_end_ = nullptr;
  const std::vector<double>* time_ = nullptr;
};

}  // namespace meshknit
