#pragma once

#include <algorithm>
#include <vector>

#include "meshknit/remesh/sweep_plan.h"

namespace meshknit {

/// Which vertices the present step of peeling may knit. Everything else stays open for later.
class KnitLimits {
 public:
  explicit KnitLimits(const SweepPlan& plan)
      : plan_(plan), open_(plan.regions(), 0), forced_(plan.regions(), 0) {}

  void close_all() {
    std::fill(open_.begin(), open_.end(), 0);
    std::fill(forced_.begin(), forced_.end(), 0);
  }
  void open(int region) { open_[region] = 1; }
  /// What is left of this region belongs to this step, whatever its distance.
  void finish(int region) { open_[region] = forced_[region] = 1; }

  bool may_knit(int vertex) const { return open_[plan_.region[vertex]] != 0; }
  bool must_knit(int vertex) const { return forced_[plan_.region[vertex]] != 0; }
  const SweepPlan& plan() const { return plan_; }

 private:
  const SweepPlan& plan_;
  std::vector<char> open_, forced_;  // per region
};

}  // namespace meshknit
