#include "meshknit/transfer/collapse_shift_expand.h"

#include <algorithm>
#include <cstdlib>

namespace meshknit {
namespace {

// All triples of rackings, in both directions; at most one of them is odd, since loops go round
// one end at a time.
std::vector<Passes> iterations(int max_racking, bool rolls) {
  std::vector<Passes> found;
  for (const Bed bed : {Bed::front, Bed::back}) {
    for (int collapse = -max_racking; collapse <= max_racking; ++collapse) {
      for (int shift = -max_racking; shift <= max_racking; ++shift) {
        for (int expand = -max_racking; expand <= max_racking; ++expand) {
          const int odd = collapse % 2 != 0 ? 1 : 0;
          const int odds = odd + (shift % 2 != 0 ? 1 : 0) + (expand % 2 != 0 ? 1 : 0);
          if (odds > (rolls ? 1 : 0)) continue;
          found.push_back({{bed, collapse}, {opposite(bed), shift}, {bed, expand}});
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
    std::optional<Assignment> assignment = assigner.towards_goals(passes, penalty);
    if (!assignment || assignment->cost >= least) continue;
    least = assignment->cost;
    best = PassPlan{passes, std::move(*assignment)};
  }
  return best;
}

}  // namespace meshknit
