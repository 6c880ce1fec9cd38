#pragma once

#include <algorithm>
#include <vector>

#include "meshknit/remesh/sweep_plan.h"

namespace meshknit {

/// Which vertices the present step of peeling may knit. Everything else stays open for later.
class KnitLimits {
 public:
  explicit KnitLimits(const SweepPlan& plan)
      : plan_(plan), open_(plan.regions(), 0) {}

  void close_all() { std::fill(open_.begin(), open_.end(), 0); forced_ = -1; }
  void open(int region) { open_[region] = 1; }
  /// The junction of this event is being knit: its surroundings belong to this step, whatever
  /// their distance.
  void open_junction(int event) {
    forced_ = plan_.event_region(event);
    open_[forced_] = 1;
  }

  bool may_knit(int vertex) const { return open_[plan_.region[vertex]] != 0; }
  bool must_knit(int vertex) const { return plan_.region[vertex] == forced_; }
  const SweepPlan& plan() const { return plan_; }

 private:
  const SweepPlan& plan_;
  std::vector<char> open_;  // per region
  int forced_ = -1;
};

}  // namespace meshknit
