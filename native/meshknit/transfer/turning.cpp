#include "meshknit/transfer/turning.h"

#include <algorithm>
#include <cstdlib>

namespace meshknit {
namespace {

constexpr int kLoops = 2;  // that roll at either end in a turn

// How many places aside a turn may bring the tube, and in how many passes.
struct Turn {
  int passes;
  std::vector<int> asides;
};
const Turn kTurns[] = {{6, {-2, 2}}, {7, {-1, 0, 1}}};

// Rolls that are still to come, + anticlockwise; 0 if stacks go both ways.
int rolls_one_way(const Tube& tube) {
  int sum = 0;
  bool forwards = false, backwards = false;
  for (const Stack& stack : tube.stacks) {
    sum += stack.roll();
    forwards = forwards || stack.roll() > 0;
    backwards = backwards || stack.roll() < 0;
  }
  return forwards && backwards ? 0 : sum;
}

// The tube, with the goals of a turn: `loops` stacks anticlockwise, `aside` places to the right.
Tube turned(const Tube& tube, int loops, int aside) {
  const int count = static_cast<int>(tube.stacks.size());
  Tube turned = tube;
  for (int i = 0; i < count; ++i) {
    const int to = ((i + loops) % count + count) % count;
    const int rounds = (i + loops - to) / count;
    turned.stacks[i].goal_side = tube.stacks[to].side + 2 * rounds;
    turned.stacks[i].goal = tube.stacks[to].place + aside;
  }
  return turned;
}

bool inside(const Tube& tube) {
  return std::all_of(tube.stacks.begin(), tube.stacks.end(), [&](const Stack& stack) {
    return stack.goal >= tube.lowest && stack.goal <= tube.highest;
  });
}

// How far a tube that went to its goals would hang aside from where the other one ends, in half
// places.
int distance_aside(const Tube& a, const Tube& b) {
  const auto middle = [](const Tube& tube) {
    const auto [left, right] =
        std::minmax_element(tube.stacks.begin(), tube.stacks.end(),
                            [](const Stack& x, const Stack& y) { return x.goal < y.goal; });
    return left->goal + right->goal;
  };
  return std::abs(middle(a) - middle(b));
}

}  // namespace

std::optional<PassPlan> turn_by_two(const Tube& tube, PairWaysCache& cache) {
  const int rolls = rolls_one_way(tube);
  if (std::abs(rolls) <= 2 * kLoops) return std::nullopt;
  for (const Turn& turn : kTurns) {
    std::optional<PassPlan> best;
    int least = 0;
    for (const int aside : turn.asides) {
      const Tube goal = turned(tube, rolls > 0 ? kLoops : -kLoops, aside);
      const int distance = distance_aside(goal, tube);
      if (!inside(goal) || (best && distance >= least)) continue;
      std::optional<PassPlan> plan = search_passes(goal, cache, 1, turn.passes);
      if (!plan) continue;
      best = std::move(plan);
      least = distance;
    }
    if (best) return best;
  }
  return std::nullopt;
}

}  // namespace meshknit
