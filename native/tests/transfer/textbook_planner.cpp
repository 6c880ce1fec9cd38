#include "transfer/textbook_planner.h"

#include <set>
#include <utility>

#include "meshknit/transfer/collapse_shift_expand.h"
#include "meshknit/transfer/tube.h"

namespace meshknit {

TextbookPlan collapse_shift_expand_alone(const TransferProblem& problem) {
  Tube tube = make_tube(problem);
  TextbookPlan result;
  while (!tube.arrived() && result.arrived)
    result.arrived = collapse_shift_expand(tube, result.plan);
  return result;
}

int count_slider_passes(const TransferPlan& plan) {
  using Kind = std::pair<bool, bool>;  // from a slider, to a slider
  int passes = 0;
  std::set<Kind> kinds;  // at this racking
  const Transfer* before = nullptr;
  for (const Transfer& transfer : plan.transfers) {
    if (before &&
        (before->from.bed != transfer.from.bed || racking_of(*before) != racking_of(transfer)))
      kinds.clear();
    if (kinds.insert({transfer.from.parked, transfer.to.parked}).second) ++passes;
    before = &transfer;
  }
  return passes;
}

}  // namespace meshknit
