#include "meshknit/transfer/pair_ways.h"

#include <algorithm>
#include <cstdlib>

namespace meshknit {
namespace {

constexpr int stray = 2;  // places beyond a stack's stretch

bool home(const Stack& stack, const Stop& stop) {
  return !stop.parked && stop.side == stack.goal_side && stop.place == stack.goal;
}

// What a stack may do in a pass: stay, or go.
std::vector<Stop> stops_after(const Stack& stack, const Stop& here, const Pass& pass) {
  std::vector<Stop> stops{here};
  if (here.bed() != pass.from) return stops;
  Stop there = here;
  there.place += shift_of(pass);
  const auto [low, high] = std::minmax(stack.place, stack.goal);
  if (there.place < low - stray || there.place > high + stray) return stops;
  if (!changes_side(pass)) {
    there.parked = !here.parked;
  } else {
    if (here.parked || here.side == stack.goal_side) return stops;
    there.side += here.side < stack.goal_side ? 1 : -1;
  }
  stops.push_back(there);
  return stops;
}

// Numbers the stops that a stack may make.
class StopNumbers {
 public:
  explicit StopNumbers(const Stack& stack)
      : side_(std::min(stack.side, stack.goal_side)),
        place_(std::min(stack.place, stack.goal) - stray),
        places_(std::abs(stack.goal - stack.place) + 2 * stray + 1),
        size_(2 * places_ * (std::abs(stack.roll()) + 1)) {}
  int size() const { return size_; }
  int operator()(const Stop& stop) const {
    return ((stop.side - side_) * places_ + stop.place - place_) * 2 + stop.parked;
  }

 private:
  int side_, place_, places_, size_;
};

}  // namespace

PairWays::PairWays(const Stack& a, const Stack& b, int turn, int max_racking) {
  find_states(a, b, turn, max_racking);
  measure(a, b);
}

std::vector<int> PairWays::key(const Stack& a, const Stack& b, int turn, int max_racking) {
  return {a.side & 1,        a.roll(), a.goal - a.place, b.side + turn - a.side,
          b.place - a.place, b.roll(), b.goal - b.place, a.slack,
          max_racking};
}

void PairWays::find_states(const Stack& a, const Stack& b, int turn, int max_racking) {
  const StopNumbers number_a(a), number_b(b);
  std::vector<int> number_of(static_cast<std::size_t>(number_a.size()) * number_b.size(), -1);
  const auto state_of = [&](const Stop& stop_a, const Stop& stop_b) {
    int& number = number_of[number_a(stop_a) * number_b.size() + number_b(stop_b)];
    if (number < 0) {
      number = static_cast<int>(states_.size());
      states_.push_back({stop_a, stop_b});
    }
    return number;
  };
  state_of({a.side, a.place, false}, {b.side, b.place, false});
  for (std::size_t s = 0; s < states_.size(); ++s) {
    const State from = states_[s];
    for (const Bed bed : {Bed::front, Bed::back}) {
      for (int racking = -most_racking; racking <= most_racking; ++racking) {
        begin_.push_back(static_cast<int>(next_.size()));
        const Pass pass{bed, racking};
        if (std::abs(racking) > max_racking) continue;
        for (const Stop& to_a : stops_after(a, from.a, pass))
          for (const Stop& to_b : stops_after(b, from.b, pass))
            if (compatible_in(pass, a, from.a, to_a, b, from.b, to_b, turn))
              next_.push_back(state_of(to_a, to_b));
      }
    }
  }
  begin_.push_back(static_cast<int>(next_.size()));
}

// Round after round: a state is one pass further from home than the nearest of those after it.
void PairWays::measure(const Stack& a, const Stack& b) {
  const int count = static_cast<int>(states_.size());
  std::vector<std::vector<int>> before(count);
  for (int s = 0; s < count; ++s)
    for (int i = range(s, 0).first; i < range(s, all_passes - 1).second; ++i)
      before[next_[i]].push_back(s);
  passes_home_.assign(count, far);
  std::vector<int> reached;
  for (int s = 0; s < count; ++s) {
    if (!home(a, states_[s].a) || !home(b, states_[s].b)) continue;
    passes_home_[s] = 0;
    reached.push_back(s);
  }
  for (std::size_t i = 0; i < reached.size(); ++i) {
    for (const int s : before[reached[i]]) {
      if (passes_home_[s] != far) continue;
      passes_home_[s] =
          static_cast<std::uint8_t>(std::min(far - 1, passes_home_[reached[i]] + 1));
      reached.push_back(s);
    }
  }
  allowed_.assign(count, {});
  for (int s = 0; s < count; ++s) {
    for (int p = 0; p < all_passes; ++p) {
      const auto [begin, end] = range(s, p);
      int least = far;
      for (int i = begin; i < end; ++i) least = std::min<int>(least, passes_home_[next_[i]]);
      for (int left = least; left < most_left; ++left)
        allowed_[s][left] |= std::uint32_t{1} << p;
    }
  }
}

const PairWays& PairWaysCache::ways(const Stack& a, const Stack& b, int turn, int max_racking) {
  std::vector<int> key = PairWays::key(a, b, turn, max_racking);
  const auto known = known_.find(key);
  if (known != known_.end()) return known->second;
  return known_.emplace(std::move(key), PairWays(a, b, turn, max_racking)).first->second;
}

}  // namespace meshknit
