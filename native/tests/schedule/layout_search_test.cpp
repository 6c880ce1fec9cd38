#include "meshknit/schedule/layout_search.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cstdlib>
#include <limits>

#include "meshknit/schedule/layout_cost.h"
#include "schedule/random_map.h"

namespace meshknit {
namespace {

// alignment, roll, places beyond reach, shift, travel
using Cost = std::array<long, 5>;

Cost operator+(const Cost& a, const Cost& b) {
  Cost sum{};
  for (size_t i = 0; i < sum.size(); ++i) sum[i] = a[i] + b[i];
  return sum;
}

// Counts what happens to every stack, needle by needle, at the best of many offsets.
Cost cost_of_move(const SlotMap& map, const BedLayout& before, const BedLayout& after) {
  Cost best;
  best.fill(std::numeric_limits<long>::max() / 4);
  for (int offset = -12; offset <= 12; ++offset) {
    Cost cost{};
    for (int stack = 0; stack < map.stacks(); ++stack) {
      const Hook from = slot_hook(before, stack);
      const Hook to = slot_hook(after, map.slot_of(stack) % map.slots());
      const int places = std::abs(to.n + offset - from.n);
      cost[1] += from.bed != to.bed ? 1 : 0;
      cost[2] += std::max(0, places - 2);
      cost[3] += places > 0 ? 1 : 0;
      cost[4] += places;
    }
    best = std::min(best, cost);
  }
  return best;
}

std::vector<BedLayout> all_layouts(int slots) {
  std::vector<BedLayout> layouts;
  for (const BedShape& shape : bed_shapes(slots))
    for (int first = 0; first < slots; ++first) layouts.push_back({slots, first, shape, 0});
  return layouts;
}

Cost alignment(const BedLayout& layout) { return {is_aligned(layout) ? 0 : 1, 0, 0, 0, 0}; }

// Every layout of every cycle, every move between them: nothing is left out.
Cost exhaustive_search(int slots, const std::vector<SlotMap>& maps) {
  std::vector<BedLayout> layouts = all_layouts(slots);
  std::vector<Cost> reached;
  for (const BedLayout& layout : layouts) reached.push_back(alignment(layout));
  for (const SlotMap& map : maps) {
    const std::vector<BedLayout> next = all_layouts(map.slots());
    std::vector<Cost> reached_next;
    for (const BedLayout& to : next) {
      Cost best;
      best.fill(std::numeric_limits<long>::max() / 4);
      for (size_t from = 0; from < layouts.size(); ++from)
        best = std::min(best, reached[from] + cost_of_move(map, layouts[from], to));
      reached_next.push_back(best + alignment(to));
    }
    layouts = next;
    reached = reached_next;
  }
  return *std::min_element(reached.begin(), reached.end());
}

Cost cost_of_way(const std::vector<BedLayout>& way, const std::vector<SlotMap>& maps) {
  Cost cost = alignment(way[0]);
  for (size_t i = 0; i < maps.size(); ++i)
    cost = cost + cost_of_move(maps[i], way[i], way[i + 1]) + alignment(way[i + 1]);
  return cost;
}

TEST(LayoutSearch, FindsWhatExhaustiveSearchFinds) {
  for (std::uint32_t seed = 0; seed < 150; ++seed) {
    Dice dice(seed);
    const int slots = 3 + dice.roll(6);
    std::vector<SlotMap> maps;
    for (int i = 0, n = slots, steps = 1 + dice.roll(4); i < steps && n <= 9; ++i) {
      maps.push_back(random_map(dice, n));
      n = maps.back().slots();
    }
    ASSERT_EQ(cost_of_way(search_layouts(slots, maps).layouts, maps),
              exhaustive_search(slots, maps))
        << "seed " << seed;
  }
}

TEST(LayoutSearch, ASixLoopTubeHasThirtyLayoutsAndAFiveLoopTubeTwenty) {
  EXPECT_EQ(all_layouts(6).size(), 30u);  // 5N for N even
  EXPECT_EQ(all_layouts(5).size(), 20u);  // 4N for N odd
}

TEST(LayoutCost, CountsOnRunsWhatCountingOneByOneFinds) {
  ShiftMeter meter;
  for (std::uint32_t seed = 0; seed < 60; ++seed) {
    Dice dice(seed);
    const SlotMap map = random_map(dice, 4 + dice.roll(6));
    for (const BedLayout& before : all_layouts(map.stacks()))
      for (const BedLayout& after : all_layouts(map.slots())) {
        const ShiftCost measured = meter.measure(map, before, after);
        const Cost counted = cost_of_move(map, before, after);
        const Cost together{0, count_rolls(map, before, after), measured.beyond, measured.shift,
                            measured.travel};
        ASSERT_EQ(together, counted) << "seed " << seed;
      }
  }
}

}  // namespace
}  // namespace meshknit
