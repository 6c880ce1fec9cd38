#include "meshknit/transfer/collapse_shift_expand.h"

#include <array>
#include <cstdlib>

namespace meshknit {
namespace {

bool odd(int racking) { return racking % 2 != 0; }

// Collapse, shift, expand; or a collapse or an expansion in two passes, for stacks of a
// decrease that must arrive one after the other and for loops that go round an end while others
// are parked.
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

long remaining_way(const Tube& tube, const Stack& stack, const Stop& stop) {
  int side = stop.side, place = stop.place;
  long way = 0;
  while (side != stack.goal_side) {
    const bool anticlockwise = side < stack.goal_side;
    const bool right_end = (bed_of_side(side) == Bed::front) == anticlockwise;
    const int end = right_end ? tube.right_end : tube.left_end;
    way += std::abs(end - place) + 2;
    place = end;
    side += anticlockwise ? 1 : -1;
  }
  return way + std::abs(stack.goal - place);
}

std::optional<PassPlan> collapse_shift_expand(const Tube& tube) {
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
