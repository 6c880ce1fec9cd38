#pragma once

#include <array>
#include <optional>
#include <vector>

#include "meshknit/core/run_context.h"
#include "meshknit/schedule/bed_order.h"
#include "meshknit/schedule/connections.h"
#include "meshknit/schedule/layout_search.h"
#include "meshknit/schedule/needle_offsets.h"
#include "meshknit/schedule/tube_steps.h"

namespace meshknit {

/// The best layouts of every tube (layout_search.h), depending on which way round the
/// connections below and above it hang. Each is searched for once.
///
/// A step that neither increases nor decreases keeps the layout of the step before: one move seldom
/// takes more passes than the same move made in parts. Where both ends of a tube are given and none of its steps shapes it, its last step moves it from
/// the one layout to the other.
/// Requires: tubes and connections that outlive it.
class LayoutChoices {
 public:
  LayoutChoices(const SteppedTubes& tubes, const std::vector<Connection>& connections);

  /// [tube]. All zero if there is nothing to choose: one tube, no connection. Where a tube would have
  /// to turn much further than if its connections hung otherwise, about what the turning costs.
  /// Throws: Cancelled.
  std::vector<TubeCosts> costs(RunContext* run);

  /// [tube]. `narrow` as in LayoutLimits. Throws: Cancelled.
  std::vector<TubeLayouts> layouts(const BedOrder& order, bool narrow, RunContext* run);

 private:
  LayoutLimits limits(int tube, int left_below, int left_above) const;
  int first_slots(int tube) const;
  TubeCosts costs_of(int tube, RunContext* run);
  const FoundLayouts& found(int tube, int left_below, int left_above, RunContext* run);

  const SteppedTubes& tubes_;
  const std::vector<Connection>& connections_;
  std::vector<int> below_, above_;    // [tube] its connections, -1 for none
  std::vector<TubeLayouts> shaping_;  // [tube] maps and their steps
  // [tube][which part is left at the connection below][the same above] what was searched so far
  std::vector<std::array<std::array<std::optional<FoundLayouts>, 2>, 2>> found_;
};

}  // namespace meshknit
