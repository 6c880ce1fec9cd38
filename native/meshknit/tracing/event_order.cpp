#include "meshknit/tracing/event_order.h"

#include <algorithm>
#include <cstdint>
#include <set>
#include <utility>

#include "meshknit/knit_graph/ring_parts.h"
#include "meshknit/knit_graph/rows.h"

namespace meshknit {
namespace {

constexpr std::size_t kMostStates = 100000;
constexpr std::size_t kMostEvents = 64;

using Row = std::vector<int>;  // tubes, left to right

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

// Puts tubes that part from a closed row, or meet in it, into the order in which they hang.
void put_side_by_side(const KnitGraph& graph, const Tubes& tubes,
                      std::vector<TubeLinks>& links) {
  const RowWalk walk(graph);
  for (std::size_t row = 0; row < graph.rows.size(); ++row) {
    if (!graph.rows[row].closed) continue;
    TubeLinks& own = links[tubes.of_row[row]];
    for (const bool up : {false, true}) {
      std::vector<int>& others = up ? own.above : own.below;
      std::vector<int> part;
      for (const int node : graph.rows[row].nodes)
        for (const int other : up ? walk.above(node) : walk.below(node)) {
          const int tube = tubes.of_row[walk.place(other).row];
          if (tube != tubes.of_row[row]) part.push_back(tube);
        }
      if (others.size() < 3 || part.empty()) continue;
      const std::vector<PartStretch> stretches = ring_parts(part);
      if (stretches.size() != 2 * (others.size() - 1)) continue;
      for (std::size_t k = 0; k < others.size(); ++k) others[k] = stretches[k].part;
    }
  }
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

  bool can_hang() {
    const std::size_t all = events_.size();
    return all > kMostEvents || in_order_of_time(all) || search(all);
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
        for (Row parts : {own.above, Row(own.above.rbegin(), own.above.rend())}) {
          if (!hangs) break;
          after = row;
          after.insert(after.erase(after.begin() + at), parts.begin(), parts.end());
          rows.push_back(after);
        }
        break;
      case TubeEvent::Kind::merge: {
        const auto first =
            std::find_first_of(after.begin(), after.end(), own.below.begin(), own.below.end());
        Row parts = own.below;
        if (first != after.end() && *first != parts.front())
          std::reverse(parts.begin(), parts.end());
        if (after.end() - first < static_cast<long>(parts.size()) ||
            !std::equal(parts.begin(), parts.end(), first))
          break;
        *first = event.tube;
        after.erase(first + 1, first + static_cast<long>(parts.size()));
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

bool can_hang(const std::vector<TubeLinks>& tubes) { return EventSearch(tubes).can_hang(); }

std::vector<TubeEvent> find_event_order(const KnitGraph& graph, const Tubes& tubes,
                                        int most_tubes) {
  if (tubes.count < 2) return {};
  std::vector<TubeLinks> links = link_tubes(graph, tubes);
  put_side_by_side(graph, tubes, links);
  return EventSearch(std::move(links)).run(static_cast<std::size_t>(most_tubes));
}

}  // namespace meshknit
