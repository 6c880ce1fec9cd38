#include "meshknit/transfer/collapse_shift_expand.h"

#include <algorithm>
#include <cstdlib>
#include <tuple>
#include <utility>

#include "meshknit/transfer/crossing.h"

namespace meshknit {
namespace {

long remaining_way(const CollapsingTube& state) {
  long sum = 0;
  for (const HangingRun& run : state.hanging)
    sum += run.size() * remaining_way(state.tube, run.stack, run.stop());
  return sum;
}

std::vector<HangingRun> runs_of(const Tube& tube) {
  std::vector<HangingRun> runs;
  for (const Block& block : cut_into_blocks(tube)) {
    HangingRun run;
    run.stack = tube.stacks[block.first];
    for (int i = block.first + 1; i <= block.last; ++i) {
      run.beyond.push_back(tube.stacks[i].place - run.stack.place);
      run.slacks.push_back(tube.stacks[i - 1].slack);
    }
    run.stack.slack = tube.stacks[block.last].slack;
    runs.push_back(std::move(run));
  }
  return runs;
}

void append_stacks(const HangingRun& run, std::vector<Stack>& stacks) {
  Stack stack = run.stack;
  for (int i = 0; i < run.size(); ++i) {
    const int beyond = i == 0 ? 0 : run.beyond[i - 1];
    stack.place = run.stack.place + beyond;
    stack.goal = run.stack.goal + beyond;
    stack.slack = i + 1 == run.size() ? run.stack.slack : run.slacks[i];
    stacks.push_back(stack);
  }
}

// Loops that met on a needle go on as one.
void merge(CollapsingTube& state) {
  std::vector<HangingRun> merged;
  for (const HangingRun& run : state.hanging) {
    if (!merged.empty() && merged.back().stop() == run.stop())
      merged.back().stack.slack = run.stack.slack;
    else
      merged.push_back(run);
  }
  while (merged.size() > 1 && merged.back().stack.side == merged.front().stack.side + 2 &&
         merged.back().stack.place == merged.front().stack.place &&
         merged.back().parked == merged.front().parked)
    merged.pop_back();
  state.hanging = std::move(merged);
}

// Lets the list begin with the stacks of the side on this bed.
void begin_with(CollapsingTube& state, Bed bed) {
  const int n = state.count();
  const auto side_before = [&](int i) {
    return i > 0 ? state.hanging[i - 1].stack.side : state.hanging[n - 1].stack.side - 2;
  };
  int begin = 0;
  for (int i = 0; i < n; ++i) {
    const int side = state.hanging[i].stack.side;
    if (bed_of_side(side) == bed && side != side_before(i)) begin = i;
  }
  for (int i = 0; i < begin; ++i) {
    state.hanging[i].stack.side += 2;
    state.hanging[i].stack.goal_side += 2;
  }
  std::rotate(state.hanging.begin(), state.hanging.begin() + begin, state.hanging.end());
  state.top = 0;
  while (state.top < n && bed_of_side(state.hanging[state.top].stack.side) == bed) ++state.top;
}

// All stacks hang on one bed, hooks and parking needles, and come over together.
void shift_all(CollapsingTube& state) {
  const Bed from = state.hanging[0].stop().bed();
  const int most = state.tube.max_racking - state.tube.max_racking % 2;
  std::optional<std::tuple<long, int, int>> best;
  for (int racking = -most; racking <= most; racking += 2) {
    const int by = shift_of({from, racking});
    long way = 0;
    bool inside = true;
    for (int i = 0; i < state.count(); ++i) {
      const HangingRun& run = state.hanging[i];
      Stop stop = run.stop();
      stop.place += by;
      const auto [low, high] = std::minmax({stop.place, stop.place + run.reach()});
      inside = inside && low >= state.tube.lowest && high <= state.tube.highest;
      way += run.size() * remaining_way(state.tube, run.stack, stop);
    }
    const auto cost = std::make_tuple(way, std::abs(racking), racking);
    if (inside && (!best || cost < *best)) best = cost;
  }
  const Pass pass{from, std::get<2>(*best)};
  for (HangingRun& run : state.hanging) {
    const Stop here = run.stop();
    append_move(state, run, {here.side, here.place + shift_of(pass), !here.parked});
  }
  state.pass = pass;
}

std::optional<CollapsingTube> iteration(CollapsingTube state, Bed top) {
  begin_with(state, top);
  if (!cross(state, Crossing::collapse)) return std::nullopt;
  merge(state);
  shift_all(state);
  begin_with(state, top);
  if (state.top < state.count() && !cross(state, Crossing::expand)) return std::nullopt;
  merge(state);
  return state;
}

}  // namespace

bool collapse_shift_expand(Tube& tube, TransferPlan& plan) {
  CollapsingTube state;
  state.tube = tube;
  state.hanging = runs_of(tube);
  if (!plan.transfers.empty())
    state.pass = Pass{plan.transfers.back().from.bed, racking_of(plan.transfers.back())};
  const auto cost = [](const CollapsingTube& s) {
    return std::make_pair(remaining_way(s), count_passes(s.plan));
  };
  std::optional<CollapsingTube> best;
  for (const Bed top : {Bed::front, Bed::back}) {
    std::optional<CollapsingTube> after = iteration(state, top);
    if (!after || remaining_way(*after) >= remaining_way(state)) continue;
    if (!best || cost(*after) < cost(*best)) best = std::move(after);
  }
  if (!best) return false;
  plan.transfers.insert(plan.transfers.end(), best->plan.transfers.begin(),
                        best->plan.transfers.end());
  tube.stacks.clear();
  for (const HangingRun& run : best->hanging) append_stacks(run, tube.stacks);
  return true;
}

}  // namespace meshknit
