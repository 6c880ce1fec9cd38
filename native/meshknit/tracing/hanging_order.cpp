#include "meshknit/tracing/hanging_order.h"

#include <algorithm>
#include <set>
#include <utility>

namespace meshknit {
namespace {

constexpr std::size_t kMostStates = 20000;

// What hangs, and which tubes that stand on nothing have been started: all that the future depends on.
struct State {
  TubesOnBed row;
  std::vector<bool> started;  // [tube]
};

class HangingSearch {
 public:
  // `own`: the tubes of one piece of the object.
  HangingSearch(const std::vector<TubeLinks>& tubes, const std::vector<bool>& own)
      : tubes_(tubes), to_start_(tubes.size(), false) {
    for (const TubeEvent& event : events_in_time(tubes)) {
      if (event.kind != TubeEvent::Kind::start || !own[event.tube]) continue;
      starts_.push_back(event.tube);
      to_start_[event.tube] = true;
    }
  }

  HangingOrder run() {
    HangingOrder order;
    if (follow({{}, std::vector<bool>(tubes_.size(), false)})) {
      order.verdict = HangingOrder::Verdict::found;
      order.events.assign(order_.rbegin(), order_.rend());
    } else if (tried_.size() < kMostStates) {
      order.verdict = HangingOrder::Verdict::none;
    }
    return order;
  }

 private:
  bool is_unstarted(const State& state, int tube) const {
    return to_start_[tube] && !state.started[tube];
  }

  // The tube that takes this one over together with others; -1 if none does.
  int meets_in(int tube) const {
    const std::vector<int>& above = tubes_[tube].above;
    return above.size() == 1 && tubes_[above.front()].below.size() > 1 ? above.front() : -1;
  }

  // What can be done at once without spoiling any order; tube -1 if there is nothing.
  TubeEvent due(const TubesOnBed& row) const {
    for (const int tube : row)
      if (tubes_[tube].above.empty()) return {TubeEvent::Kind::end, tube};
    for (const int tube : row) {
      const TubeEvent merge{TubeEvent::Kind::merge, meets_in(tube)};
      if (merge.tube >= 0 && !rows_after(tubes_, row, merge).empty()) return merge;
    }
    for (const int tube : row)
      if (tubes_[tube].above.size() > 1) return {TubeEvent::Kind::split, tube};
    return {TubeEvent::Kind::start, -1};
  }

  // Starts tubes right beside or between those that they meet, if nothing else is in the way: waiting
  // would leave no more orders. Returns what was started.
  std::vector<int> start_missing(State& state) const {
    for (const int tube : state.row) {
      const int whole = meets_in(tube);
      if (whole < 0) continue;
      std::vector<int> missing;
      TubesOnBed hanging;
      for (const int part : tubes_[whole].below) {
        const bool hangs = std::count(state.row.begin(), state.row.end(), part) > 0;
        if (hangs) hanging.push_back(part);
        if (!hangs && is_unstarted(state, part)) missing.push_back(part);
      }
      if (missing.empty() || missing.size() + hanging.size() != tubes_[whole].below.size())
        continue;
      const auto at =
          std::search(state.row.begin(), state.row.end(), hanging.begin(), hanging.end());
      if (at == state.row.end()) continue;
      const std::vector<int>& parts = tubes_[whole].below;
      const auto place = state.row.erase(at, at + static_cast<long>(hanging.size()));
      state.row.insert(place, parts.begin(), parts.end());
      for (const int part : missing) state.started[part] = true;
      return missing;
    }
    return {};
  }

  // Of tubes that all start and meet at once, any can be the first.
  bool may_start(const State& state, int tube) const {
    if (state.started[tube]) return false;
    const int whole = meets_in(tube);
    if (whole < 0) return true;
    const std::vector<int>& parts = tubes_[whole].below;
    return parts.front() == tube || !std::all_of(parts.begin(), parts.end(), [&](int part) {
             return is_unstarted(state, part);
           });
  }

  // Writes the order down from its end.
  bool follow(State state) {
    const TubeEvent event = due(state.row);
    if (event.tube >= 0) return go_on(state, event);
    const std::vector<int> missing = start_missing(state);
    if (!missing.empty()) {
      if (!follow(state)) return false;
      for (const int tube : missing) order_.push_back({TubeEvent::Kind::start, tube});
      return true;
    }
    if (state.row.empty() && std::count(state.started.begin(), state.started.end(), true) ==
                                 static_cast<long>(starts_.size()))
      return true;
    // Seen from behind, the bed is the same.
    const TubesOnBed turned(state.row.rbegin(), state.row.rend());
    if (tried_.size() >= kMostStates ||
        !tried_.insert({state.started, std::min(state.row, turned)}).second)
      return false;
    for (const int tube : starts_) {
      if (!may_start(state, tube)) continue;
      State after = state;
      after.started[tube] = true;
      if (go_on(after, {TubeEvent::Kind::start, tube})) return true;
    }
    return false;
  }

  bool go_on(const State& state, const TubeEvent& event) {
    for (TubesOnBed& row : rows_after(tubes_, state.row, event))
      if (follow({std::move(row), state.started})) {
        order_.push_back(event);
        return true;
      }
    return false;
  }

  const std::vector<TubeLinks>& tubes_;
  std::vector<int> starts_;     // earliest first
  std::vector<bool> to_start_;  // [tube]
  std::set<std::pair<std::vector<bool>, TubesOnBed>> tried_;
  std::vector<TubeEvent> order_;
};

// [piece][tube]: the tubes that hang together, in pieces that can be knit one after another.
std::vector<std::vector<bool>> pieces_of(const std::vector<TubeLinks>& tubes) {
  std::vector<std::vector<bool>> pieces;
  std::vector<bool> known(tubes.size(), false);
  for (std::size_t first = 0; first < tubes.size(); ++first) {
    if (known[first]) continue;
    pieces.emplace_back(tubes.size(), false);
    std::vector<std::size_t> left{first};
    while (!left.empty()) {
      const std::size_t tube = left.back();
      left.pop_back();
      if (known[tube]) continue;
      known[tube] = pieces.back()[tube] = true;
      left.insert(left.end(), tubes[tube].below.begin(), tubes[tube].below.end());
      left.insert(left.end(), tubes[tube].above.begin(), tubes[tube].above.end());
    }
  }
  return pieces;
}

}  // namespace

HangingOrder find_hanging_order(const std::vector<TubeLinks>& tubes) {
  HangingOrder all;
  all.verdict = HangingOrder::Verdict::found;
  for (const std::vector<bool>& piece : pieces_of(tubes)) {
    const HangingOrder own = HangingSearch(tubes, piece).run();
    if (own.verdict != HangingOrder::Verdict::found) return own;
    all.events.insert(all.events.end(), own.events.begin(), own.events.end());
  }
  return all;
}

bool can_hang(const std::vector<TubeLinks>& tubes) {
  return find_hanging_order(tubes).verdict != HangingOrder::Verdict::none;
}

}  // namespace meshknit
