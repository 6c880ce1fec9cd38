#include "meshknit/schedule/bed_order.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <limits>
#include <optional>

#include "graphs.h"
#include "meshknit/core/error.h"

namespace meshknit {
namespace {

/// Tubes that start, part, meet and end: no stitches, only who follows whom. A tube has one step,
/// or a second one at the very end.
class DrawnTubes {
 public:
  int start() { return add({}); }
  std::array<int, 2> split(int whole) {
    const std::array<int, 2> parts{add({whole}), add({whole})};
    connect(true, whole, parts);
    return parts;
  }
  int merge(int a, int b) {
    const int whole = add({a, b});
    connect(false, whole, {a, b});
    return whole;
  }

  /// Tubes that nothing takes over go on until all others are knit.
  void outlast() {
    for (int tube = 0; tube < static_cast<int>(tubes.tubes.size()); ++tube) {
      if (!tubes.tubes[tube].above.empty()) continue;
      tubes.tubes[tube].steps.resize(2);
      tubes.turns.push_back({tube, 1});
    }
  }

  SteppedTubes tubes;
  std::vector<Connection> connections;
  StitchTrace trace;

 private:
  int add(std::vector<int> below) {
    const int tube = static_cast<int>(tubes.tubes.size());
    TubeSteps steps;
    steps.steps.resize(1);
    steps.steps[0].first_stitch = steps.steps[0].last_stitch = tube;
    steps.below = below;
    tubes.tubes.push_back(steps);
    tubes.turns.push_back({tube, 0});
    for (const int t : below) tubes.tubes[t].above.push_back(tube);
    trace.stitches.emplace_back();
    trace.stitches.back().node = tube;
    return tube;
  }
  void connect(bool split, int whole, const std::array<int, 2>& parts) {
    Connection connection;
    connection.split = split;
    connection.whole = whole;
    connection.parts = {parts[0], parts[1]};
    connection.first = split ? parts[0] : whole;
    connections.push_back(connection);
  }
};

/// Up to 12 tubes; those that nothing takes over end at once or outlast the others.
DrawnTubes random_tubes(Dice& dice) {
  DrawnTubes drawn;
  std::vector<int> open{drawn.start()};
  while (drawn.tubes.tubes.size() < 11) {
    const int kind = dice.roll(7), at = dice.roll(static_cast<int>(open.size()));
    if (kind == 0 && open.size() < 4) {
      open.push_back(drawn.start());
    } else if (open.size() < (kind <= 2 ? 5u : 3u)) {
      const auto parts = drawn.split(open[at]);
      open[at] = parts[0];
      open.push_back(parts[1]);
    } else if (open.size() >= 2) {
      const int other = (at + 1 + dice.roll(static_cast<int>(open.size()) - 1)) %
                        static_cast<int>(open.size());
      open[at] = drawn.merge(open[at], open[other]);
      open.erase(open.begin() + other);
    }
  }
  if (dice.roll(2) == 0) drawn.outlast();
  return drawn;
}

std::vector<TubeCosts> random_costs(const DrawnTubes& drawn, Dice& dice) {
  std::vector<TubeCosts> costs(drawn.tubes.tubes.size());
  for (TubeCosts& cost : costs)
    for (auto& row : cost)
      for (TubeCost& c : row) c = {dice.roll(3), dice.roll(5), dice.roll(5)};
  return costs;
}

/// Tries every choice one after another: which part is left, and where a tube starts.
class ExhaustiveOrder {
 public:
  ExhaustiveOrder(const DrawnTubes& drawn, const std::vector<TubeCosts>& costs)
      : drawn_(drawn), costs_(costs) {}

  /// None if all ways cross.
  std::optional<TubeCost> least() {
    follow(0, {}, TubeCost{});
    return best_;
  }

 private:
  struct Held {
    int tube, left_below;
  };

  static TubeCost plus(TubeCost a, const TubeCost& b) {
    for (std::size_t i = 0; i < a.size(); ++i) a[i] += b[i];
    return a;
  }

  void follow(std::size_t turn, std::vector<Held> row, const TubeCost& cost) {
    if (turn == drawn_.tubes.turns.size()) {
      if (!best_ || cost < *best_) best_ = cost;
      return;
    }
    const int tube = drawn_.tubes.turns[turn].tube;
    const TubeSteps& steps = drawn_.tubes.tubes[tube];
    const auto at = [&](int t) {
      return std::find_if(row.begin(), row.end(), [&](const Held& h) { return h.tube == t; });
    };
    const int step = drawn_.tubes.turns[turn].step;
    const auto go_on = [&](std::vector<Held> next, TubeCost sum) {
      if (steps.above.empty() && step + 1 == static_cast<int>(steps.steps.size())) {
        const auto ended = std::find_if(next.begin(), next.end(),
                                        [&](const Held& h) { return h.tube == tube; });
        sum = plus(sum, costs_[tube][ended->left_below][0]);
        next.erase(ended);
      }
      follow(turn + 1, next, sum);
    };
    if (step > 0) {
      go_on(row, cost);
    } else if (steps.below.empty()) {
      for (std::size_t place = 0; place <= row.size(); ++place) {
        std::vector<Held> next = row;
        next.insert(next.begin() + static_cast<long>(place), {tube, 0});
        go_on(next, cost);
      }
    } else if (steps.below.size() == 1) {
      const int whole = steps.below[0];
      if (at(whole) == row.end()) return go_on(row, cost);  // its sibling has split it
      const std::vector<int>& parts = drawn_.tubes.tubes[whole].above;
      for (const int left : {0, 1}) {
        std::vector<Held> next = row;
        const auto split = next.begin() + (at(whole) - row.begin());
        const TubeCost sum = plus(cost, costs_[whole][split->left_below][left]);
        *split = {parts[left], left};
        next.insert(split + 1, {parts[1 - left], left});
        go_on(next, sum);
      }
    } else {
      const auto a = at(steps.below[0]), b = at(steps.below[1]);
      if (a - b != 1 && b - a != 1) return;
      const int left = a < b ? 0 : 1;
      const TubeCost sum = plus(plus(cost, costs_[a->tube][a->left_below][left]),
                                costs_[b->tube][b->left_below][left]);
      std::vector<Held> next = row;
      const auto first = next.begin() + (std::min(a, b) - row.begin());
      *first = {tube, left};
      next.erase(first + 1);
      go_on(next, sum);
    }
  }

  const DrawnTubes& drawn_;
  const std::vector<TubeCosts>& costs_;
  std::optional<TubeCost> best_;
};

/// The cost of the order that was chosen.
TubeCost cost_of(const DrawnTubes& drawn, const std::vector<TubeCosts>& costs,
                 const BedOrder& order) {
  std::vector<int> below(costs.size(), 0), above(costs.size(), 0);
  for (std::size_t c = 0; c < drawn.connections.size(); ++c) {
    const Connection& connection = drawn.connections[c];
    const int left = order.left_part[c];
    (connection.split ? above : below)[connection.whole] = left;
    for (const int part : connection.parts) (connection.split ? below : above)[part] = left;
  }
  TubeCost sum{};
  for (std::size_t t = 0; t < costs.size(); ++t)
    for (std::size_t i = 0; i < sum.size(); ++i) sum[i] += costs[t][below[t]][above[t]][i];
  return sum;
}

TEST(BedOrder, IsAsCheapAsTheBestOfAllOrders) {
  int crossing = 0, orders = 0;
  for (std::uint64_t seed = 0; seed < 1500; ++seed) {
    Dice dice(seed);
    const DrawnTubes drawn = random_tubes(dice);
    const std::vector<TubeCosts> costs = random_costs(drawn, dice);
    const std::optional<TubeCost> least = ExhaustiveOrder(drawn, costs).least();
    try {
      const BedOrder order = choose_order(drawn.trace, drawn.tubes, drawn.connections, costs);
      ASSERT_TRUE(least) << "seed " << seed << " crosses";
      ASSERT_TRUE(order.optimal);
      ASSERT_EQ(cost_of(drawn, costs, order), *least) << "seed " << seed;
      ++orders;
    } catch (const NotKnittable& refused) {
      ASSERT_FALSE(least) << "seed " << seed << " has an order without crossing";
      ASSERT_NE(find_problem(refused.problems(), "tubes-cross"), nullptr);
      ++crossing;
    }
  }
  EXPECT_GT(crossing, 10) << "both cases are tried";
  EXPECT_GT(orders, 100);
}

// Two tubes part into two each. One of the first pair meets one of the second, and then the other
// two want to meet as well: between them hangs what has met before.
TEST(BedOrder, TubesThatWouldHaveToCrossAreNamed) {
  DrawnTubes drawn;
  const auto [a, b] = drawn.split(drawn.start());
  const auto [a1, a2] = drawn.split(a);
  const auto [b1, b2] = drawn.split(b);
  const int met = drawn.merge(a1, b1);
  drawn.merge(a2, b2);
  drawn.outlast();
  try {
    choose_order(drawn.trace, drawn.tubes, drawn.connections,
                 std::vector<TubeCosts>(drawn.tubes.tubes.size()));
    FAIL() << "they cross";
  } catch (const NotKnittable& refused) {
    const Problem* problem = find_problem(refused.problems(), "tubes-cross");
    ASSERT_NE(problem, nullptr);
    // A tube's only stitch has its number here.
    EXPECT_EQ(problem->elements.stitches, (std::vector<int>{a2, b2, met}));
    EXPECT_EQ(problem->elements.nodes, (std::vector<int>{a2, b2, met}));
  }
}

TEST(BedOrder, ATubeStartsOutsideIfNothingAsksForTheMiddle) {
  DrawnTubes drawn;
  const int a = drawn.start(), b = drawn.start(), c = drawn.start();
  drawn.merge(a, b);
  drawn.outlast();
  const BedOrder order = choose_order(drawn.trace, drawn.tubes, drawn.connections,
                                      std::vector<TubeCosts>(drawn.tubes.tubes.size()));
  const std::vector<int>& held = order.held[2];
  EXPECT_TRUE(held.front() == c || held.back() == c);
}

}  // namespace
}  // namespace meshknit
