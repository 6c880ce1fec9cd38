#pragma once

#include "meshknit/core/problem.h"
#include "meshknit/transfer/transfer_problem.h"

namespace meshknit {

/// Replays a plan: every transfer moves a stack that is there, racking within the limit, slack kept by every
/// neighbouring pair in every state at every racking used, order round the tube kept, only loops with one
/// target ever share a needle and in the order asked for, all places within range; at the end every loop hangs at its target. Empty if the plan is good.
Problems check_transfer_plan(const TransferProblem& problem, const TransferPlan& plan);

}  // namespace meshknit
