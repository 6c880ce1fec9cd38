#include "meshknit/tracing/event_order.h"

#include <algorithm>
#include <cstdint>
#include <cstdlib>
#include <set>
#include <utility>

#include "meshknit/knit_graph/rows.h"

namespace meshknit {
namespace {

constexpr std::size_t kMostStates = 100000;
constexpr std::size_t kMostEvents = 64;

using Row = std::vector<int>;  // tubes, left to right

/// Which tubes a tube takes over, and which take it over; when it begins and ends.
struct TubeLinks {
  std::vector<int> below, above;
  double begin = 0.0, end = 0.0;
};

double time_of(const KnitGraph& graph, const KnitRow& row) {
  double sum = 0.0;
  for (const int node : row.nodes) sum += graph.nodes[node].time;
  return sum / static_cast<double>(row.nodes.size());
}

std::vector<TubeLinks> link_tubes(const KnitGraph& graph, const Tubes& tubes) {
  std::vector<TubeLinks> links(tubes.count);
  std::vector<bool> begun(tubes.count, false);
  const RowWalk walk(graph);
  for (std::size_t row = 0; row < graph.rows.size(); ++row) {
    const int tube = tubes.of_row[row];
    TubeLinks& own = links[tube];
    const double time = time_of(graph, graph.rows[row]);
    own.begin = begun[tube] ? std::min(own.begin, time) : time;
    own.end = begun[tube] ? std::max(own.end, time) : time;
    begun[tube] = true;
    for (const int node : graph.rows[row].nodes)
      for (const int below : walk.below(node)) {
        const int other = tubes.of_row[walk.place(below).row];
        if (other == tube || std::count(own.below.begin(), own.below.end(), other) > 0)
          continue;
        own.below.push_back(other);
        links[other].above.push_back(tube);
      }
  }
  return links;
}

class EventSearch {
 public:
  explicit EventSearch(std::vector<TubeLinks> links) : links_(std::move(links)) {
    std::vector<std::pair<double, TubeEvent>> timed;
    for (int tube = 0; tube < static_cast<int>(links_.size()); ++tube) {
      const TubeLinks& own = links_[tube];
      if (own.below.empty()) timed.push_back({own.begin, {TubeEvent::Kind::start, tube}});
      if (own.below.size() > 1) timed.push_back({own.begin, {TubeEvent::Kind::merge, tube}});
      if (own.above.size() > 1) {
        double begin = links_[own.above[0]].begin;
        for (const int part : own.above) begin = std::min(begin, links_[part].begin);
        timed.push_back({begin, {TubeEvent::Kind::split, tube}});
      }
      if (own.above.empty()) timed.push_back({own.end, {TubeEvent::Kind::end, tube}});
    }
    std::stable_sort(timed.begin(), timed.end(),
                     [](const auto& a, const auto& b) { return a.first < b.first; });
    for (const auto& event : timed) events_.push_back(event.second);
  }

  // With few yarns tubes must wait, which may make others cross: so few tubes hang at once, if any
  // order allows that; else none cross, if any order allows that.
  std::vector<TubeEvent> run(std::size_t most_tubes) {
    if (events_.size() > kMostEvents) return {};
    const bool time_crosses = !in_order_of_time(events_.size());
    if (!time_crosses && in_order_of_time(most_tubes)) return {};
    if (!search(most_tubes) && (!time_crosses || !search(events_.size()))) return {};
    std::reverse(order_.begin(), order_.end());
    return order_;
  }

 private:
  bool search(std::size_t most_tubes) {
    tried_.clear();
    return follow(0, {}, most_tubes);
  }

  bool in_order_of_time(std::size_t most_tubes) const {
    std::set<Row> rows{{}};
    for (const TubeEvent& event : events_) {
      std::set<Row> next;
      for (const Row& row : rows)
        for (Row& after : rows_after(row, event))
          if (after.size() <= most_tubes) next.insert(std::move(after));
      if (next.size() > kMostStates) return true;
      rows = std::move(next);
    }
    return !rows.empty();
  }

  // All rows of tubes that an event can leave; none if its tubes do not hang, or not side by side.
  std::vector<Row> rows_after(const Row& row, const TubeEvent& event) const {
    std::vector<Row> rows;
    const auto at = std::find(row.begin(), row.end(), event.tube) - row.begin();
    const bool hangs = at < static_cast<long>(row.size());
    const TubeLinks& own = links_[event.tube];
    Row after = row;
    switch (event.kind) {
      case TubeEvent::Kind::start:
        for (std::size_t place = 0; place <= row.size(); ++place) {
          after = row;
          after.insert(after.begin() + static_cast<long>(place), event.tube);
          rows.push_back(after);
        }
        break;
      case TubeEvent::Kind::end:
        if (!hangs) break;
        after.erase(after.begin() + at);
        rows.push_back(after);
        break;
      case TubeEvent::Kind::split:
        for (const int left : {0, 1}) {
          if (!hangs || own.above.size() != 2) break;
          after = row;
          after[at] = own.above[left];
          after.insert(after.begin() + at + 1, own.above[1 - left]);
          rows.push_back(after);
        }
        break;
      case TubeEvent::Kind::merge: {
        const auto a = std::find(row.begin(), row.end(), own.below[0]);
        const auto b = std::find(row.begin(), row.end(), own.below[1]);
        if (a == row.end() || b == row.end() || std::abs(a - b) != 1) break;
        const auto left = std::min(a, b) - row.begin();
        after[left] = event.tube;
        after.erase(after.begin() + left + 1);
        rows.push_back(after);
        break;
      }
    }
    return rows;
  }

  // The earliest events first; writes the order down from its end.
  bool follow(std::uint64_t done, const Row& row, std::size_t most_tubes) {
    if (done == ~std::uint64_t{0} >> (kMostEvents - events_.size())) return true;
    if (tried_.size() >= kMostStates || !tried_.insert({done, row}).second) return false;
    for (std::size_t e = 0; e < events_.size(); ++e) {
      if ((done >> e & 1) != 0) continue;
      for (const Row& after : rows_after(row, events_[e]))
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
  std::set<std::pair<std::uint64_t, Row>> tried_;
  std::vector<TubeEvent> order_;
};

}  // namespace

std::vector<TubeEvent> find_event_order(const KnitGraph& graph, const Tubes& tubes,
                                        int most_tubes) {
  if (tubes.count < 2) return {};
  return EventSearch(link_tubes(graph, tubes)).run(static_cast<std::size_t>(most_tubes));
}

}  // namespace meshknit
