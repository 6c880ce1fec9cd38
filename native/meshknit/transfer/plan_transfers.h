#pragma once

#include "meshknit/transfer/transfer_problem.h"

namespace meshknit {

/// The cheapest plan of the known ways: passes first, then racking travel, then transfers.
/// Local moves are tried first, collapse-shift-expand is the fallback (knitout primer, section
/// 4).
/// Throws: InvalidInput if the problem is not of the form that TransferProblem requires;
/// NotKnittable (code "transfer-impossible") if no plan keeps the limits.
/// Ensures: check_transfer_plan(problem, result) finds nothing.
TransferPlan plan_transfers(const TransferProblem& problem);

}  // namespace meshknit
