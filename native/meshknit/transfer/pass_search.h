#pragma once

#include <optional>

#include "meshknit/transfer/pair_ways.h"
#include "meshknit/transfer/pass_assignment.h"

namespace meshknit {

/// Passes and who moves in them.
struct PassPlan {
  Passes passes;
  Assignment assignment;
};

/// Carries a plan out on the tube: every stack where its way ends, stacks that met made one,
/// the transfers appended to `plan`.
void advance(Tube& tube, const PassPlan& step, TransferPlan& plan);

/// The way home with the fewest passes, then the least racking travel, then the fewest
/// transfers. Sequences of passes are tried shortest first: all of them while they are few,
/// longer ones in legs, that is runs of passes in one direction whose rackings rise or fall
/// steadily (a schoolbus that returns loops offset by offset is one leg out and one leg back).
/// None if no sequence of `least` to `most` passes was found; that proves nothing.
/// Requires: not tube.arrived().
std::optional<PassPlan> search_passes(const Tube& tube, PairWaysCache& cache, int least,
                                      int most);

}  // namespace meshknit
