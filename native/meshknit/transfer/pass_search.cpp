#include "meshknit/transfer/pass_search.h"

#include <algorithm>

#include "meshknit/transfer/pass_sequences.h"

namespace meshknit {
namespace {

std::optional<PassPlan> first_that_works(PassAssigner& assigner,
                                         const std::vector<Passes>& sequences) {
  for (const Passes& passes : sequences)
    if (std::optional<Assignment> assignment = assigner.to_goals(passes))
      return PassPlan{passes, std::move(*assignment)};
  return std::nullopt;
}

// Legs are even rackings only, with which no loop changes beds.
bool goes_round_an_end(const Tube& tube) {
  return std::any_of(tube.stacks.begin(), tube.stacks.end(),
                     [](const Stack& stack) { return stack.roll() != 0; });
}

}  // namespace

void advance(Tube& tube, const PassPlan& step, TransferPlan& plan) {
  append_transfers(tube, step.passes, step.assignment, plan);
  for (std::size_t i = 0; i < tube.stacks.size(); ++i) {
    const Stop& end = step.assignment.ways[i].stops[step.passes.size()];
    tube.stacks[i].side = end.side;
    tube.stacks[i].place = end.place;
  }
  merge_stacks(tube);
}

std::optional<PassPlan> search_passes(const Tube& tube, PairWaysCache& cache, int most) {
  PassAssigner assigner(tube);
  PassSequences sequences(tube, cache);
  const bool rolls = goes_round_an_end(tube);
  for (int length = sequences.least_length(); length <= std::min(most, most_passes); ++length) {
    const bool all = !sequences.gave_up();
    if (all) {
      if (auto plan = first_that_works(assigner, sequences.of_length(length))) return plan;
    } else if (rolls) {
      return std::nullopt;
    }
    if (!sequences.gave_up()) continue;
    if (auto plan = first_that_works(assigner, sequences_in_legs(tube, length))) return plan;
  }
  return std::nullopt;
}

}  // namespace meshknit
