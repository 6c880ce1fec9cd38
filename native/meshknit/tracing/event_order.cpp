#include "meshknit/tracing/event_order.h"

#include <cstdint>
#include <set>
#include <utility>

#include "meshknit/tracing/hanging_order.h"
#include "meshknit/tracing/tube_links.h"

namespace meshknit {
namespace {

constexpr std::size_t kMostStates = 100000;
constexpr std::size_t kMostEvents = 64;

// True if tubes can hang in this order of events, no more than `most_tubes` at once, or in too many
// ways to try.
bool can_follow(const std::vector<TubeLinks>& links, const std::vector<TubeEvent>& events,
                std::size_t most_tubes) {
  std::set<TubesOnBed> rows{{}};
  for (const TubeEvent& event : events) {
    std::set<TubesOnBed> next;
    for (const TubesOnBed& row : rows)
      for (TubesOnBed& after : rows_after(links, row, event))
        if (after.size() <= most_tubes) next.insert(std::move(after));
    if (next.size() > kMostStates) return true;
    rows = std::move(next);
  }
  return !rows.empty();
}

class EventSearch {
 public:
  explicit EventSearch(std::vector<TubeLinks> links)
      : links_(std::move(links)), events_(events_in_time(links_)) {}

  // With few yarns tubes must wait, which may make others cross: so few tubes hang at once, if any
  // order allows that; else none cross, if any order allows that.
  std::vector<TubeEvent> run(std::size_t most_tubes) {
    const bool time_crosses = !in_order_of_time(events_.size());
    if (!time_crosses && in_order_of_time(most_tubes)) return {};
    if (search(most_tubes) || (time_crosses && search(events_.size())))
      return {order_.rbegin(), order_.rend()};
    return time_crosses ? find_hanging_order(links_).events : std::vector<TubeEvent>();
  }

 private:
  bool search(std::size_t most_tubes) {
    tried_.clear();
    return events_.size() <= kMostEvents && follow(0, {}, most_tubes);
  }

  bool in_order_of_time(std::size_t most_tubes) const {
    return can_follow(links_, events_, most_tubes);
  }

  // The earliest events first; writes the order down from its end.
  bool follow(std::uint64_t done, const TubesOnBed& row, std::size_t most_tubes) {
    if (done == ~std::uint64_t{0} >> (kMostEvents - events_.size())) return true;
    if (tried_.size() >= kMostStates || !tried_.insert({done, row}).second) return false;
    for (std::size_t e = 0; e < events_.size(); ++e) {
      if ((done >> e & 1) != 0) continue;
      for (const TubesOnBed& after : rows_after(links_, row, events_[e]))
        if (after.size() <= most_tubes &&
            follow(done | std::uint64_t{1} << e, after, most_tubes)) {
          order_.push_back(events_[e]);
          return true;
        }
    }
    return false;
  }

  std::vector<TubeLinks> links_;
  std::vector<TubeEvent> events_;  // in the order of time
  std::set<std::pair<std::uint64_t, TubesOnBed>> tried_;
  std::vector<TubeEvent> order_;
};

}  // namespace

std::vector<TubeEvent> find_event_order(const KnitGraph& graph, const Tubes& tubes,
                                        int most_tubes) {
  if (tubes.count < 2) return {};
  return EventSearch(link_tubes(graph, tubes)).run(static_cast<std::size_t>(most_tubes));
}

std::vector<std::vector<TubeEvent>> more_event_orders(const KnitGraph& graph,
                                                      const Tubes& tubes) {
  const std::vector<TubeLinks> links = link_tubes(graph, tubes);
  std::vector<std::vector<TubeEvent>> orders;
  std::vector<TubeEvent> in_time = events_in_time(links);
  if (can_follow(links, in_time, in_time.size())) orders.push_back(std::move(in_time));
  HangingOrder hanging = find_hanging_order(links);
  if (hanging.verdict == HangingOrder::Verdict::found)
    orders.push_back(std::move(hanging.events));
  return orders;
}

bool tubes_cross(const KnitGraph& graph, const Tubes& tubes, const StitchTrace& trace) {
  std::vector<TubeLinks> links = link_tubes(graph, tubes);
  std::vector<bool> begun(links.size(), false);
  for (int s = 0; s < static_cast<int>(trace.stitches.size()); ++s) {
    const int tube = trace.stitches[s].tube;
    if (!begun[tube]) links[tube].begin = s;
    links[tube].end = s;
    begun[tube] = true;
  }
  const std::vector<TubeEvent> events = events_in_time(links);
  return !can_follow(links, events, events.size());
}

}  // namespace meshknit
