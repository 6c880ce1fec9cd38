#include "transfer/textbook_planner.h"

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

}  // namespace meshknit
