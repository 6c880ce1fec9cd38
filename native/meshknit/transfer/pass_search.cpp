#include "meshknit/transfer/pass_search.h"

#include <algorithm>
#include <cstdlib>

#include "meshknit/transfer/pass_sequences.h"

namespace meshknit {
namespace {

// With more loops that go round an end every search is given up.
constexpr int most_rolling = 8;

std::optional<PassPlan> first_that_works(PassAssigner& assigner,
                                         const std::vector<Passes>& sequences) {
  for (const Passes& passes : sequences)
    if (std::optional<Assignment> assignment = assigner.to_goals(passes))
      return PassPlan{passes, std::move(*assignment)};
  return std::nullopt;
}

int count_rolling(const Tube& tube) {
  return static_cast<int>(std::count_if(tube.stacks.begin(), tube.stacks.end(),
                                        [](const Stack& stack) { return stack.roll() != 0; }));
}

// Of the stack with the longest way, were it alone: every other pass is one back, and a loop
// that goes round an end needs none.
int fewest_passes(const Tube& tube) {
  const int places = std::max(1, (tube.max_racking + 1) / 2);  // a pass
  int most = 0;
  for (const Stack& stack : tube.stacks) {
    const int sideways = (std::abs(stack.goal - stack.place) + places - 1) / places;
    most = std::max({most, sideways, std::abs(stack.roll())});
  }
  return most;
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

std::optional<PassPlan> search_passes(const Tube& tube, PairWaysCache& cache, int least,
                                      int most) {
  const int rolling = count_rolling(tube);
  if (fewest_passes(tube) > most || rolling > most_rolling) return std::nullopt;
  PassAssigner assigner(tube);
  PassSequences sequences(tube, cache);
  for (int length = std::max(least, sequences.least_length());
       length <= std::min(most, most_passes); ++length) {
    const bool all = !sequences.gave_up();
    if (all) {
      if (auto plan = first_that_works(assigner, sequences.of_length(length))) return plan;
    } else if (rolling > 0) {
      // Legs are even rackings only, with which no loop changes beds.
      return std::nullopt;
    }
    if (!sequences.gave_up()) continue;
    if (auto plan = first_that_works(assigner, sequences_in_legs(tube, length))) return plan;
  }
  return std::nullopt;
}

}  // namespace meshknit
