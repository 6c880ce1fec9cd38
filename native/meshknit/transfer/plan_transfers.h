#pragma once

#include "meshknit/transfer/pair_ways.h"
#include "meshknit/transfer/transfer_problem.h"

namespace meshknit {

/// Plans transfers, and keeps what it learns about pairs of loops for the next plan. Plans do not
/// depend on the ones before.
class TransferPlanner {
 public:
  /// The cheapest plan of the known ways: passes first, then racking travel, then transfers.
  /// A tube that many loops must go round is turned first (transfer/turning.h), then local moves
  /// are searched for; collapse-shift-expand is the fallback (knitout primer, section 4).
  /// Throws: InvalidInput if the problem is not of the form that TransferProblem requires;
  /// NotKnittable (code "transfer-impossible") if no plan keeps the limits.
  /// Ensures: check_transfer_plan(problem, result) finds nothing.
  TransferPlan plan(const TransferProblem& problem);

 private:
  PairWaysCache cache_;
};

/// A plan of a planner of its own.
TransferPlan plan_transfers(const TransferProblem& problem);

}  // namespace meshknit
