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

}  // namespace meshknit
