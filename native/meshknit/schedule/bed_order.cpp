#include "meshknit/schedule/bed_order.h"

#include <algorithm>
#include <map>
#include <string>
#include <tuple>
#include <utility>

#include "meshknit/core/error.h"

namespace meshknit {
namespace {

constexpr size_t kMostStates = 20000;

// A tube on the bed, and which outer part was left at the connection below it.
struct Held {
  int tube = 0, left_below = 0;
  friend bool operator<(const Held& a, const Held& b) {
    return std::tie(a.tube, a.left_below) < std::tie(b.tube, b.left_below);
  }
};
using Row = std::vector<Held>;

using OrderCost = std::array<long, 4>;  // a TubeCost summed up, and tubes that make room

// The last choice of a way through the events, and the way before it.
struct Choice {
  int before = -1;
  int connection = -1, left = 0;
  Row row;
};

struct Way {
  OrderCost cost{};
  int choice = -1;
};

void add(OrderCost& sum, const TubeCost& cost) {
  for (size_t i = 0; i < cost.size(); ++i) sum[i] += cost[i];
}

class OrderSearch {
 public:
  OrderSearch(const StitchTrace& trace, const SteppedTubes& tubes,
              const std::vector<Connection>& connections, const std::vector<TubeCosts>& costs)
      : trace_(trace),
        tubes_(tubes),
        connections_(connections),
        costs_(costs),
        below_(tubes.tubes.size(), -1) {
    for (int c = 0; c < static_cast<int>(connections.size()); ++c) {
      const Connection& connection = connections[c];
      if (!connection.split) below_[connection.whole] = c;
      if (connection.split)
        for (const int part : connection.parts) below_[part] = c;
    }
  }

  BedOrder run() {
    ways_[{}] = {};
    for (const SteppedTubes::Turn& turn : tubes_.turns) {
      if (turn.step == 0) begin(turn.tube);
      events_at_turn_.push_back(events_);
      const TubeSteps& tube = tubes_.tubes[turn.tube];
      if (turn.step + 1 == static_cast<int>(tube.steps.size()) && tube.above.empty())
        finish(turn.tube);
    }
    return walk_back();
  }

 private:
  using Ways = std::map<Row, Way>;

  void begin(int tube) {
    const int c = below_[tube];
    if (c < 0) return start(tube);
    const Connection& connection = connections_[c];
    if (!connection.split) return merge(c);
    if (tube == connection.first) split(c);
  }

  void start(int tube) {
    Ways next;
    for (const auto& [row, way] : ways_)
      for (size_t at = 0; at <= row.size(); ++at) {
        Row longer = row;
        longer.insert(longer.begin() + static_cast<long>(at), {tube, 0});
        OrderCost cost = way.cost;
        cost.back() += static_cast<long>(std::min(at, row.size() - at));
        offer(next, longer, cost, way, -1, 0);
      }
    take(std::move(next));
  }

  void split(int c) {
    const Connection& connection = connections_[c];
    Ways next;
    for (const auto& [row, way] : ways_)
      for (const int left : {0, 1}) {
        Row longer = row;
        const auto at = find(longer, connection.whole);
        std::vector<Held> parts;
        for (const int part : connection.parts) parts.push_back({part, left});
        if (left != 0) std::reverse(parts.begin(), parts.end());
        OrderCost cost = way.cost;
        add(cost, costs_[connection.whole][at->left_below][left]);
        const auto place = longer.erase(at);
        longer.insert(place, parts.begin(), parts.end());
        offer(next, longer, cost, way, c, left);
      }
    take(std::move(next));
  }

  void merge(int c) {
    const Connection& connection = connections_[c];
    Ways next;
    for (const auto& [row, way] : ways_) {
      Row shorter = row;
      auto first = std::find_if(shorter.begin(), shorter.end(),
                                [&](const Held& held) { return is_part(connection, held); });
      const int left = first->tube == connection.parts.front() ? 0 : 1;
      std::vector<int> order = connection.parts;
      if (left != 0) std::reverse(order.begin(), order.end());
      if (shorter.end() - first < static_cast<long>(order.size())) continue;
      const auto last = first + static_cast<long>(order.size());
      if (!std::equal(first, last, order.begin(),
                      [](const Held& held, int tube) { return held.tube == tube; }))
        continue;
      OrderCost cost = way.cost;
      for (auto held = first; held != last; ++held)
        add(cost, costs_[held->tube][held->left_below][left]);
      *first = {connection.whole, left};
      shorter.erase(first + 1, last);
      offer(next, shorter, cost, way, c, left);
    }
    if (next.empty()) refuse_crossing(connection);
    take(std::move(next));
  }

  void finish(int tube) {
    Ways next;
    for (const auto& [row, way] : ways_) {
      Row shorter = row;
      const auto at = find(shorter, tube);
      OrderCost cost = way.cost;
      add(cost, costs_[tube][at->left_below][0]);
      shorter.erase(at);
      offer(next, shorter, cost, way, -1, 0);
    }
    take(std::move(next));
  }

  static bool is_part(const Connection& connection, const Held& held) {
    return std::count(connection.parts.begin(), connection.parts.end(), held.tube) > 0;
  }

  static Row::iterator find(Row& row, int tube) {
    return std::find_if(row.begin(), row.end(),
                        [&](const Held& held) { return held.tube == tube; });
  }

  void offer(Ways& next, const Row& row, const OrderCost& cost, const Way& way, int connection,
             int left) {
    const auto known = next.find(row);
    if (known != next.end() && !(cost < known->second.cost)) return;
    choices_.push_back({way.choice, connection, left, row});
    next[row] = {cost, static_cast<int>(choices_.size()) - 1};
  }

  void take(Ways next) {
    ++events_;
    if (next.size() > kMostStates) {
      optimal_ = false;
      std::vector<std::pair<OrderCost, Row>> by_cost;
      for (const auto& [row, way] : next) by_cost.push_back({way.cost, row});
      std::sort(by_cost.begin(), by_cost.end());
      for (size_t i = kMostStates; i < by_cost.size(); ++i) next.erase(by_cost[i].second);
    }
    ways_ = std::move(next);
  }

  [[noreturn]] void refuse_crossing(const Connection& connection) {
    std::vector<int> between;
    bool found = false;
    for (const auto& way : ways_) {
      const Row& row = way.first;
      const auto part = [&](const Held& held) { return is_part(connection, held); };
      const auto first = std::find_if(row.begin(), row.end(), part);
      const auto end = std::find_if(row.rbegin(), row.rend(), part).base();
      std::vector<int> here;
      for (auto held = first; held < end; ++held)
        if (!part(*held)) here.push_back(held->tube);
      if (found && here.size() >= between.size()) continue;
      found = true;
      between = here;
    }
    const auto first_stitch = [&](int tube) {
      return tubes_.tubes[tube].steps.front().first_stitch;
    };
    Problem problem;
    problem.code = "tubes-cross";
    const std::string others =
        between.empty() ? "each other"
        : between.size() == 1
            ? "another tube that hangs between them"
            : std::to_string(between.size()) + " other tubes that hang between them";
    problem.message = "The tubes that meet at stitch " +
                      std::to_string(first_stitch(connection.whole)) + " would have to cross " +
                      others + ".";
    problem.remedy =
        "Change the knitting times so that the tube between them ends first, or allow seams.";
    between.insert(between.begin(), connection.parts.begin(), connection.parts.end());
    for (const int tube : between) {
      problem.elements.stitches.push_back(first_stitch(tube));
      problem.elements.nodes.push_back(trace_.stitches[first_stitch(tube)].node);
    }
    throw NotKnittable({problem});
  }

  BedOrder walk_back() {
    BedOrder order;
    order.optimal = optimal_;
    order.left_part.assign(connections_.size(), 0);
    std::vector<Row> rows(events_ + 1);
    int event = events_;
    for (int at = ways_.begin()->second.choice; at >= 0; at = choices_[at].before, --event) {
      rows[event] = choices_[at].row;
      if (choices_[at].connection >= 0)
        order.left_part[choices_[at].connection] = choices_[at].left;
    }
    for (const int last : events_at_turn_) {
      order.held.emplace_back();
      for (const Held& held : rows[last]) order.held.back().push_back(held.tube);
    }
    return order;
  }

  const StitchTrace& trace_;
  const SteppedTubes& tubes_;
  const std::vector<Connection>& connections_;
  const std::vector<TubeCosts>& costs_;
  std::vector<int> below_;  // [tube] the connection that it begins with
  Ways ways_;
  std::vector<Choice> choices_;
  int events_ = 0;                   // so far
  std::vector<int> events_at_turn_;  // [turn] events before it is knit
  bool optimal_ = true;
};

}  // namespace

BedOrder choose_order(const StitchTrace& trace, const SteppedTubes& tubes,
                      const std::vector<Connection>& connections,
                      const std::vector<TubeCosts>& costs) {
  return OrderSearch(trace, tubes, connections, costs).run();
}

}  // namespace meshknit
