#pragma once

#include <Eigen/Core>
#include <vector>

#include "meshknit/surface/surface.h"
#include "meshknit/time_field/time_field.h"

namespace meshknit {

/// Times for the boundaries of a surface with which rows move on alike fast everywhere: the gradient of
/// the harmonic field should be the same along every limb, so what flows through a boundary must be as
/// much as the limb behind it is round. One linear equation a boundary, in the fluxes of the fields
/// that are 1 on one boundary and 0 on the others.
class RimTimes {
 public:
  /// Throws: InvalidInput as TimeFieldSolver does.
  explicit RimTimes(const Surface& surface);

  /// Times in [-1, 1], -1 and 1 among them, in steps of 0.01; nearly equal ones are made equal, so that
  /// what can part or meet in one row does. `is_start` tells of every boundary whether it is a start;
  /// else it is an end.
  /// Requires: at least one of each.
  std::vector<double> even_times(const std::vector<char>& is_start) const;

  /// The harmonic field with these times on the boundaries.
  std::vector<double> field(const std::vector<double>& times) const {
    return solver_.solve(times);
  }

 private:
  TimeFieldSolver solver_;
  Eigen::MatrixXd flux_;       // [boundary][which one is 1]
  std::vector<double> girth_;  // [boundary] mm
};

}  // namespace meshknit
