#include "meshknit/transfer/tube.h"

#include <algorithm>
#include <cstdlib>

namespace meshknit {
namespace {

// The side of the next stack round the tube: the same bed further on, the other bed, or the
// same bed again after going all the way round.
int following_side(int side, int place, Bed next_bed, int next_place) {
  if (bed_of_side(side) != next_bed) return side + 1;
  const bool further = next_bed == Bed::front ? next_place >= place : next_place <= place;
  return further ? side : side + 2;
}

// Whole turns of the targets that bring the sum of |roll| to its least.
int best_turn(const std::vector<Stack>& stacks) {
  int best = 0;
  long least = -1;
  for (const int turn : {0, -2, 2, -4, 4}) {
    long rolls = 0;
    for (const Stack& stack : stacks) rolls += std::abs(stack.roll() + turn);
    if (least < 0 || rolls < least) {
      least = rolls;
      best = turn;
    }
  }
  return best;
}

}  // namespace

bool Tube::arrived() const {
  return std::all_of(stacks.begin(), stacks.end(), [](const Stack& stack) {
    return stack.side == stack.goal_side && stack.place == stack.goal;
  });
}

Tube make_tube(const TransferProblem& problem) {
  Tube tube;
  tube.lowest = problem.lowest;
  tube.highest = problem.highest;
  tube.max_racking = problem.max_racking;
  for (std::size_t i = 0; i < problem.loops.size(); ++i) {
    const TransferLoop& loop = problem.loops[i];
    Stack stack;
    stack.place = loop.from;
    stack.goal = loop.to;
    stack.slack = problem.slack[i];
    if (tube.stacks.empty()) {
      stack.side = loop.from_bed == Bed::front ? 0 : 1;
      stack.goal_side = loop.to_bed == Bed::front ? 0 : 1;
    } else {
      const Stack& before = tube.stacks.back();
      stack.side = following_side(before.side, before.place, loop.from_bed, loop.from);
      stack.goal_side = following_side(before.goal_side, before.goal, loop.to_bed, loop.to);
    }
    tube.stacks.push_back(stack);
  }
  tube.left_end = tube.highest;
  tube.right_end = tube.lowest;
  const int turn = best_turn(tube.stacks);
  for (Stack& stack : tube.stacks) {
    stack.goal_side += turn;
    tube.left_end = std::min({tube.left_end, stack.place, stack.goal});
    tube.right_end = std::max({tube.right_end, stack.place, stack.goal});
  }
  return tube;
}

void merge_stacks(Tube& tube) {
  std::vector<Stack> merged;
  for (const Stack& stack : tube.stacks) {
    if (!merged.empty() && merged.back().side == stack.side &&
        merged.back().place == stack.place)
      merged.back().slack = stack.slack;
    else
      merged.push_back(stack);
  }
  while (merged.size() > 1 && merged.back().side == merged.front().side + 2 &&
         merged.back().place == merged.front().place) {
    merged.pop_back();
  }
  tube.stacks = std::move(merged);
}

std::vector<Block> cut_into_blocks(const Tube& tube) {
  std::vector<Block> blocks;
  const int count = static_cast<int>(tube.stacks.size());
  for (int first = 0; first < count;) {
    const Stack& stack = tube.stacks[first];
    int last = first;
    while (last + 1 < count && stack.roll() == 0 && tube.stacks[last + 1].roll() == 0 &&
           tube.stacks[last + 1].side == stack.side &&
           tube.stacks[last + 1].goal - tube.stacks[last + 1].place == stack.goal - stack.place)
      ++last;
    blocks.push_back({first, first});
    if (last - first > 1) blocks.push_back({first + 1, last - 1});
    if (last > first) blocks.push_back({last, last});
    first = last + 1;
  }
  return blocks;
}

}  // namespace meshknit
