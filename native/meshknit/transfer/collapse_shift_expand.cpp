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
  for (const HangingStack& hanging : state.hanging)
    sum += remaining_way(state.tube, hanging.stack, hanging.stop());
  return sum;
}

// Loops that met on a needle go on as one.
void merge(CollapsingTube& state) {
  std::vector<HangingStack> merged;
  for (const HangingStack& hanging : state.hanging) {
    if (!merged.empty() && merged.back().stop() == hanging.stop())
      merged.back().stack.slack = hanging.stack.slack;
    else
      merged.push_back(hanging);
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
      Stop stop = state.hanging[i].stop();
      stop.place += by;
      inside = inside && stop.place >= state.tube.lowest && stop.place <= state.tube.highest;
      way += remaining_way(state.tube, state.hanging[i].stack, stop);
    }
    const auto cost = std::make_tuple(way, std::abs(racking), racking);
    if (inside && (!best || cost < *best)) best = cost;
  }
  const Pass pass{from, std::get<2>(*best)};
  for (HangingStack& hanging : state.hanging) {
    const Stop here = hanging.stop();
    const Stop there{here.side, here.place + shift_of(pass), !here.parked};
    state.plan.transfers.push_back(
        {{here.bed(), here.place, here.parked}, {there.bed(), there.place, there.parked}});
    hanging.go_to(there);
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
  for (const Stack& stack : tube.stacks) state.hanging.push_back({stack, false});
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
  for (const HangingStack& hanging : best->hanging) tube.stacks.push_back(hanging.stack);
  return true;
}

}  // namespace meshknit
