#pragma once

#include "meshknit/transfer/transfer_problem.h"

namespace meshknit {

/// A plan of the textbook, and whether it went all the way.
struct TextbookPlan {
  TransferPlan plan;
  bool arrived = true;
};

/// Collapse-shift-expand alone, iteration after iteration (transfer/collapse_shift_expand.h): the
/// yardstick for plans of ours. It stops where an iteration brings the tube no nearer to its goal.
/// Requires: check_transfer_form finds nothing.
/// Ensures: if it arrived, check_transfer_plan finds nothing.
TextbookPlan collapse_shift_expand_alone(const TransferProblem& problem);

/// Passes of a plan on a machine with sliders, as the method was published and its figures are
/// given (knitout primer, section 4): a pass is transfers of one kind at one racking, hook to
/// slider, slider to hook, or hook to hook. Parked loops are those on sliders. In half gauge
/// (count_passes) parking needles are hooks like any other, and kinds share passes.
int count_slider_passes(const TransferPlan& plan);

}  // namespace meshknit
