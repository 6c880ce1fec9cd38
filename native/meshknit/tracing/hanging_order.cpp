#include "meshknit/tracing/hanging_order.h"

#include <algorithm>
#include <set>
#include <utility>

namespace meshknit {
namespace {

constexpr std::size_t kMostStates = 20000;

class HangingSearch {
 public:
  explicit HangingSearch(const std::vector<TubeLinks>& tubes) : tubes_(tubes) {
    for (const TubeEvent& event : events_in_time(tubes))
      if (event.kind == TubeEvent::Kind::start) starts_.push_back(event.tube);
  }

  HangingOrder run() {
    HangingOrder order;
    if (follow({}, std::vector<bool>(starts_.size(), false))) {
      order.verdict = HangingOrder::Verdict::found;
      order.events.assign(order_.rbegin(), order_.rend());
    } else if (tried_.size() < kMostStates) {
      order.verdict = HangingOrder::Verdict::none;
    }
    return order;
  }

 private:
  // What can be done at once without spoiling any order; `tube` -1 if nothing is left.
  TubeEvent due(const TubesOnBed& row) const {
    for (const int tube : row)
      if (tubes_[tube].above.empty()) return {TubeEvent::Kind::end, tube};
    for (const int tube : row) {
      const std::vector<int>& above = tubes_[tube].above;
      const TubeEvent merge{TubeEvent::Kind::merge, above.front()};
      if (above.size() == 1 && tubes_[merge.tube].below.size() > 1 &&
          !rows_after(tubes_, row, merge).empty())
        return merge;
    }
    for (const int tube : row)
      if (tubes_[tube].above.size() > 1) return {TubeEvent::Kind::split, tube};
    return {TubeEvent::Kind::start, -1};
  }

  // Writes the order down from its end.
  bool follow(const TubesOnBed& row, const std::vector<bool>& started) {
    const TubeEvent event = due(row);
    if (event.tube >= 0) return go_on(row, started, event);
    if (row.empty() && std::count(started.begin(), started.end(), false) == 0) return true;
    // Seen from behind, the bed is the same.
    const TubesOnBed turned(row.rbegin(), row.rend());
    if (tried_.size() >= kMostStates || !tried_.insert({started, std::min(row, turned)}).second)
      return false;
    for (std::size_t s = 0; s < starts_.size(); ++s) {
      if (started[s]) continue;
      std::vector<bool> after = started;
      after[s] = true;
      if (go_on(row, after, {TubeEvent::Kind::start, starts_[s]})) return true;
    }
    return false;
  }

  bool go_on(const TubesOnBed& row, const std::vector<bool>& started, const TubeEvent& event) {
    for (const TubesOnBed& after : rows_after(tubes_, row, event))
      if (follow(after, started)) {
        order_.push_back(event);
        return true;
      }
    return false;
  }

  const std::vector<TubeLinks>& tubes_;
  std::vector<int> starts_;  // earliest first
  std::set<std::pair<std::vector<bool>, TubesOnBed>> tried_;
  std::vector<TubeEvent> order_;
};

}  // namespace

HangingOrder find_hanging_order(const std::vector<TubeLinks>& tubes) {
  return HangingSearch(tubes).run();
}

bool can_hang(const std::vector<TubeLinks>& tubes) {
  return find_hanging_order(tubes).verdict != HangingOrder::Verdict::none;
}

}  // namespace meshknit
