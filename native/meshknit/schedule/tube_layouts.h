#pragma once

#include <vector>

#include "meshknit/core/run_context.h"
#include "meshknit/schedule/bed_order.h"
#include "meshknit/schedule/connections.h"
#include "meshknit/schedule/layout_search.h"
#include "meshknit/schedule/needle_offsets.h"
#include "meshknit/schedule/tube_steps.h"

namespace meshknit {

/// The best layouts of every tube (layout_search.h), depending on which way round the
/// connections below and above it hang.
///
/// A step that neither increases nor decreases keeps the layout of the step before. That loses
/// nothing: rolls and shifts of one move are never more than those of the same move made in parts.
/// Where both ends of a tube are given and none of its steps shapes it, its last step moves it from
/// the one layout to the other.
/// Requires: tubes and connections that outlive it.
class LayoutChoices {
 public:
  LayoutChoices(const SteppedTubes& tubes, const std::vector<Connection>& connections);

  /// [tube]. All zero if there is nothing to choose: one tube, no connection.
  /// Throws: Cancelled.
  std::vector<TubeCosts> costs(RunContext* run) const;

  /// [tube]. Throws: Cancelled.
  std::vector<TubeLayouts> layouts(const BedOrder& order, RunContext* run) const;

 private:
  FoundLayouts search(int tube, int left_below, int left_above, RunContext* run) const;

  const SteppedTubes& tubes_;
  const std::vector<Connection>& connections_;
  std::vector<int> below_, above_;    // [tube] its connections, -1 for none
  std::vector<TubeLayouts> shaping_;  // [tube] maps and their steps
};

}  // namespace meshknit
