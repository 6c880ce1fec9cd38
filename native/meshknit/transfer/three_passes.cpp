#include "meshknit/transfer/three_passes.h"

#include <array>

namespace meshknit {
namespace {

bool odd(int racking) { return racking % 2 != 0; }

// A pass out and one back with a third before, between or after them: stacks of a decrease may
// have to arrive one after the other, and loops to go round an end while others are parked.
std::vector<Passes> iterations(int max_racking, bool rolls) {
  std::vector<Passes> found;
  for (const Bed bed : {Bed::front, Bed::back}) {
    const Bed other = opposite(bed);
    for (const auto& beds :
         {std::array<Bed, 3>{bed, other, bed}, std::array<Bed, 3>{bed, other, other},
          std::array<Bed, 3>{bed, bed, other}}) {
      for (int first = -max_racking; first <= max_racking; ++first) {
        for (int second = -max_racking; second <= max_racking; ++second) {
          for (int third = -max_racking; third <= max_racking; ++third) {
            // Loops go round one end at a time.
            if (odd(first) + odd(second) + odd(third) <= (rolls ? 1 : 0))
              found.push_back({{beds[0], first}, {beds[1], second}, {beds[2], third}});
          }
        }
      }
    }
  }
  return found;
}

}  // namespace

std::optional<PassPlan> three_passes(const Tube& tube) {
  const auto penalty = [&](const Stack& stack, const Stop& stop) {
    return remaining_way(tube, stack, stop);
  };
  bool rolls = false;
  long least = 0;
  for (const Stack& stack : tube.stacks) {
    rolls = rolls || stack.roll() != 0;
    least += penalty(stack, {stack.side, stack.place, false}) * PassAssigner::one_penalty;
  }

  PassAssigner assigner(tube);
  std::optional<PassPlan> best;
  for (const Passes& passes : iterations(tube.max_racking, rolls)) {
    std::optional<Assignment> assignment = assigner.towards_goals(passes, penalty, least);
    if (!assignment) continue;
    least = assignment->cost;
    best = PassPlan{passes, std::move(*assignment)};
  }
  return best;
}

}  // namespace meshknit
