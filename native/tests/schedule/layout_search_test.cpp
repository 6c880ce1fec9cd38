#include "meshknit/schedule/layout_search.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cstdlib>
#include <limits>
#include <map>
#include <set>
#include <tuple>

#include "meshknit/schedule/layout_cost.h"
#include "schedule/random_map.h"

namespace meshknit {
namespace {

// passes, shift, travel
using Cost = std::array<long, 3>;

Cost operator+(const Cost& a, const Cost& b) {
  Cost sum{};
  for (size_t i = 0; i < sum.size(); ++i) sum[i] = a[i] + b[i];
  return sum;
}

// Looks at every stack, needle by needle.
Cost cost_at(const SlotMap& map, const BedLayout& before, const BedLayout& after, int offset) {
  Cost cost{};
  std::set<std::tuple<Bed, Bed, int>> ways;
  bool lifted = false, far_roll = false, lower_must_come = false;
  for (int stack = 0; stack < map.stacks(); ++stack) {
    const auto way_of = [&](int of) {
      const Hook from = slot_hook(before, (of + map.stacks()) % map.stacks());
      const Hook to = slot_hook(after, (map.slot_of(of) + map.slots()) % map.slots());
      return std::tuple{from.bed, to.bed, to.n + offset - from.n};
    };
    const auto [from, to, places] = way_of(stack);
    cost[1] += places != 0 ? 1 : 0;
    cost[2] += std::abs(places);
    if (from != to) {
      // Needles 2n of the front and 2n + 1 of the back face each other at racking -1.
      const int racking = from == Bed::front ? -2 * places - 1 : 2 * places - 1;
      far_roll = far_roll || std::abs(racking) > 1;
    }
    lifted = lifted || (from == to && places != 0);
    if (from != to || places != 0) ways.insert({from, to, places});
    if (map.slot_of(stack - 1) != map.slot_of(stack)) continue;
    const int upper = map.direction() == Direction::anticlockwise ? stack : stack - 1;
    const auto [upper_from, upper_to, upper_places] = way_of(upper);
    lower_must_come = lower_must_come || (upper_from == upper_to && upper_places == 0);
  }
  for (const auto& [from, to, places] : ways)
    cost[0] += 1 + 2 * std::max(0, std::abs(places) - 2);
  if (lifted) {
    cost[0] += lower_must_come ? 2 : 1;
  } else {
    cost[0] += (lower_must_come ? 2 : 0) + (far_roll ? 2 : 0);
  }
  return cost;
}

Cost cost_of_move(const SlotMap& map, const BedLayout& before, const BedLayout& after) {
  Cost best;
  best.fill(std::numeric_limits<long>::max() / 4);
  for (int offset = -12; offset <= 12; ++offset)
    best = std::min(best, cost_at(map, before, after, offset));
  return best;
}

std::vector<BedLayout> all_layouts(int slots) {
  std::vector<BedLayout> layouts;
  for (const BedShape& shape : bed_shapes(slots))
    for (int first = 0; first < slots; ++first) layouts.push_back({slots, first, shape, 0});
  return layouts;
}

// Every layout of every cycle, every move between them; for every number of rolls on the way so far
// the least cost. Nothing is left out.
std::map<int, Cost> exhaustive_search(int slots, const std::vector<SlotMap>& maps) {
  std::vector<BedLayout> layouts = all_layouts(slots);
  std::vector<std::map<int, Cost>> reached(layouts.size(), {{0, Cost{}}});
  const auto offer = [](std::map<int, Cost>& known, int rolls, const Cost& cost) {
    const auto [at, first] = known.insert({rolls, cost});
    if (!first) at->second = std::min(at->second, cost);
  };
  for (const SlotMap& map : maps) {
    const std::vector<BedLayout> next = all_layouts(map.slots());
    std::vector<std::map<int, Cost>> reached_next(next.size());
    for (size_t to = 0; to < next.size(); ++to)
      for (size_t from = 0; from < layouts.size(); ++from) {
        const int rolls = count_rolls(map, layouts[from], next[to]);
        if (rolls > kRollsAtOnce) continue;
        const Cost move = cost_of_move(map, layouts[from], next[to]);
        for (const auto& [before, cost] : reached[from])
          offer(reached_next[to], before + rolls, cost + move);
      }
    layouts = next;
    reached = reached_next;
  }
  std::map<int, Cost> best;
  for (const std::map<int, Cost>& layout : reached)
    for (const auto& [rolls, cost] : layout) offer(best, rolls, cost);
  return best;
}

Cost cost_of_way(const std::vector<BedLayout>& way, const std::vector<SlotMap>& maps) {
  Cost cost{};
  for (size_t i = 0; i < maps.size(); ++i)
    cost = cost + cost_of_move(maps[i], way[i], way[i + 1]);
  return cost;
}

TEST(LayoutSearch, NoWayThatRollsLittleMoreThanNeededIsCheaper) {
  for (std::uint32_t seed = 0; seed < 150; ++seed) {
    Dice dice(seed);
    const int slots = 3 + dice.roll(6);
    std::vector<SlotMap> maps;
    for (int i = 0, n = slots, steps = 1 + dice.roll(4); i < steps && n <= 9; ++i) {
      maps.push_back(random_map(dice, n));
      n = maps.back().slots();
    }
    const std::map<int, Cost> best = exhaustive_search(slots, maps);
    const FoundLayouts found = search_layouts(slots, maps);
    const Cost cost = cost_of_way(found.layouts, maps);
    ASSERT_EQ(cost, (Cost{found.cost.passes, found.cost.shift, found.cost.travel}));
    const int fewest = best.begin()->first;
    ASSERT_EQ(fewest_rolls(slots, maps, {}), fewest) << "seed " << seed;
    for (const auto& [rolls, other] : best) {
      if (rolls > fewest + kMoreRolls) break;
      ASSERT_LE(cost, other) << "seed " << seed;
    }
  }
}

TEST(LayoutSearch, ASixLoopTubeHasThirtyLayoutsAndAFiveLoopTubeTwenty) {
  EXPECT_EQ(all_layouts(6).size(), 30u);  // 5N for N even
  EXPECT_EQ(all_layouts(5).size(), 20u);  // 4N for N odd
}

TEST(LayoutCost, CountsOnRunsWhatCountingOneByOneFinds) {
  MoveMeter meter;
  for (std::uint32_t seed = 0; seed < 60; ++seed) {
    Dice dice(seed);
    const SlotMap map = random_map(dice, 4 + dice.roll(6));
    for (const BedLayout& before : all_layouts(map.stacks()))
      for (const BedLayout& after : all_layouts(map.slots())) {
        const MoveCost measured = meter.measure(map, before, after);
        const Cost counted = cost_of_move(map, before, after);
        const Cost together{measured.passes, measured.shift, measured.travel};
        ASSERT_EQ(together, counted) << "seed " << seed;
      }
  }
}

}  // namespace
}  // namespace meshknit
