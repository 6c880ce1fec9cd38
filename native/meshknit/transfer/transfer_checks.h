#pragma once

#include "meshknit/core/problem.h"
#include "meshknit/transfer/transfer_problem.h"

namespace meshknit {

/// The form that TransferProblem requires: one slack a loop, limits that make sense, places in
/// range, both layouts in anticlockwise order, no shared `from`. In all problems of this header
/// `elements.stitches` holds indices of `problem.loops`; the caller knows which stitches they
/// are.
Problems check_transfer_form(const TransferProblem& problem);

/// Replays a plan: every transfer moves a stack that is there, racking within the limit, slack
/// kept by every neighbouring pair in every state at every racking used, order round the tube
/// kept, only loops with one target ever share a needle and in the order asked for, all places
/// within range; at the end every loop hangs at its target. Empty if the plan is good.
///
/// The tube is knit at racking 0 before and after, so slack is also asked of the first and the
/// last state there. Positions are compared where the beds stand: a loop on b(x) at racking R
/// lies at x + R. A parked loop keeps its side of the tube and must stay between its neighbours
/// on that side; it may face one of them, on the opposite needle. A loop changes beds hook to
/// hook and only round an end of the tube. The replay ends with the first transfer that is
/// wrong: later states would mean nothing.
/// Requires: check_transfer_form finds nothing.
Problems check_transfer_plan(const TransferProblem& problem, const TransferPlan& plan);

}  // namespace meshknit
