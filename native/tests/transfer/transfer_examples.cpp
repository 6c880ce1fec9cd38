#include "transfer/transfer_examples.h"

#include <algorithm>
#include <cstdlib>

namespace meshknit {

TransferProblem moving(const std::vector<Hanging>& before, const std::vector<Hanging>& after,
                       int room) {
  TransferProblem problem;
  problem.lowest = problem.highest = before.front().place;
  for (std::size_t i = 0; i < before.size(); ++i) {
    problem.loops.push_back({before[i].bed, before[i].place, after[i].bed, after[i].place});
    const auto [low, high] = std::minmax(before[i].place, after[i].place);
    problem.lowest = std::min(problem.lowest, low);
    problem.highest = std::max(problem.highest, high);
  }
  problem.lowest -= room;
  problem.highest += room;
  problem.slack = usual_slack(problem.loops);
  return problem;
}

std::vector<Hanging> tube_of(int front_first, int front_last, int back_first, int back_last) {
  std::vector<Hanging> tube;
  for (int n = front_first; n <= front_last; ++n) tube.push_back({Bed::front, n});
  for (int n = back_last; n >= back_first; --n) tube.push_back({Bed::back, n});
  return tube;
}

TransferProblem offsets(const std::vector<int>& front, const std::vector<int>& back, int room) {
  const std::vector<Hanging> before =
      tube_of(0, static_cast<int>(front.size()) - 1, 0, static_cast<int>(back.size()) - 1);
  std::vector<Hanging> after = before;
  for (Hanging& hanging : after)
    hanging.place += (hanging.bed == Bed::front ? front : back)[hanging.place];
  return moving(before, after, room);
}

namespace {

// Offsets that change by `step` at evenly spread places, and are about 0 in the middle.
std::vector<int> stepped_offsets(int width, int steps, int step) {
  std::vector<int> result;
  for (int n = 0; n < width; ++n) {
    const int passed = n * (steps + 1) / width;
    result.push_back(step * (passed - steps / 2));
  }
  return result;
}

}  // namespace

TransferProblem spread_decreases(int width, int decreases_a_bed) {
  const std::vector<int> steps = stepped_offsets(width, decreases_a_bed, -1);
  return offsets(steps, steps);
}

TransferProblem spread_gaps(int width, int gaps_a_bed) {
  const std::vector<int> steps = stepped_offsets(width, gaps_a_bed, 1);
  return offsets(steps, steps);
}

TransferProblem rolled(int width, int loops, int shift) {
  const std::vector<Hanging> before = tube_of(0, width - 1, 0, width - 1);
  std::vector<Hanging> after;
  const int count = static_cast<int>(before.size());
  for (int i = 0; i < count; ++i) {
    after.push_back(before[((i + loops) % count + count) % count]);
    after.back().place += shift;
  }
  return moving(before, after);
}

TransferProblem random_problem(Lcg& lcg, int most_loops_a_bed, int most_offset,
                               int most_rolls) {
  // A loop a place on each bed, then targets that keep order: each at least as far as the one
  // before (a decrease of two at most) and at most two further (a gap).
  const int front = 1 + lcg.below(most_loops_a_bed);
  const int back = std::max(1, front - 1 + lcg.below(3));
  const int back_first = lcg.below(3) - 1;
  const std::vector<Hanging> before = tube_of(0, front - 1, back_first, back_first + back - 1);
  const int count = static_cast<int>(before.size());

  // Loops that change beds: anticlockwise all beds' ends move on by `turn` loops.
  const int turn = most_rolls == 0 ? 0 : lcg.below(2 * most_rolls + 1) - most_rolls;
  std::vector<Hanging> after = before;
  for (int i = 0; i < count; ++i) after[i] = before[((i + turn) % count + count) % count];

  const int common = lcg.below(2 * most_offset + 1) - most_offset;
  for (const Bed bed : {Bed::front, Bed::back}) {
    std::vector<int> members;
    for (int i = 0; i < count; ++i)
      if (after[i].bed == bed) members.push_back(i);
    std::sort(members.begin(), members.end(),
              [&](int i, int j) { return after[i].place < after[j].place; });
    int drift = 0;
    bool stacked = false;
    for (std::size_t k = 0; k < members.size(); ++k) {
      const int roll_dice = lcg.below(8);
      const bool shrink = k > 0 && roll_dice == 0 && !stacked && common + drift > -most_offset;
      if (shrink) --drift;
      if (k > 0 && roll_dice == 1 && common + drift < most_offset) ++drift;
      stacked = shrink;
      after[members[k]].place += common + drift;
    }
  }
  return moving(before, after);
}

}  // namespace meshknit
