#pragma once

#include "meshknit/transfer/transfer_problem.h"

namespace meshknit {

/// The fewest passes of any plan, by breadth-first search over the states of the whole tube;
/// `limit` if no plan has fewer than that. A yardstick that knows nothing of the planner.
/// Exponential in the loops: for 8 or so and few passes.
int fewest_passes(const TransferProblem& problem, int limit);

}  // namespace meshknit
