#include "meshknit/schedule/roll_search.h"

#include <gtest/gtest.h>

#include <algorithm>

#include "schedule/random_map.h"

namespace meshknit {
namespace {

// Tries every move from every split to every split.
std::vector<int> fewest_by_trying(const SlotMap& map, const BedSplits& before,
                                  const BedSplits& after, const std::vector<int>& from) {
  std::vector<int> fewest(after.size(), 1 << 20);
  for (int a = 0; a < before.size(); ++a)
    for (int b = 0; b < after.size(); ++b)
      fewest[b] =
          std::min(fewest[b], from[a] + count_rolls(map, before.layout(a), after.layout(b)));
  return fewest;
}

TEST(RollSearch, SweepsFindWhatTryingEveryMoveFinds) {
  for (std::uint64_t seed = 0; seed < 60; ++seed) {
    Dice dice(seed);
    std::vector<SlotMap> maps;
    std::vector<BedSplits> splits{BedSplits(4 + dice.roll(20))};
    for (int i = 0; i < 8; ++i) {
      maps.push_back(random_map(dice, splits.back().slots()));
      splits.emplace_back(maps.back().slots());
    }
    const RollTable table = search_rolls(splits, maps, {}, nullptr);
    for (size_t i = 0; i < maps.size(); ++i)
      ASSERT_EQ(table.from_start[i + 1],
                fewest_by_trying(maps[i], splits[i], splits[i + 1], table.from_start[i]))
          << "seed " << seed;
    // What is left from a split is what a search that starts there alone finds.
    for (int split = 0; split < splits[0].size(); ++split) {
      std::vector<int> reached(splits[0].size(), 1 << 20);
      reached[split] = 0;
      for (size_t i = 0; i < maps.size(); ++i)
        reached = fewest_by_trying(maps[i], splits[i], splits[i + 1], reached);
      ASSERT_EQ(table.to_end[0][split], *std::min_element(reached.begin(), reached.end()))
          << "seed " << seed;
    }
  }
}

TEST(RollSearch, NoSplitWithinReachIsForgotten) {
  for (std::uint64_t seed = 0; seed < 60; ++seed) {
    Dice dice(seed);
    const SlotMap map = random_map(dice, 4 + dice.roll(12));
    const BedSplits before(map.stacks()), after(map.slots());
    for (int a = 0; a < before.size(); ++a)
      for (int most = 0; most <= 6; ++most) {
        int visited = 0, within = 0;
        for_each_split_within(map, before.layout(a), after, most, [&](int, int) { ++visited; });
        for (int b = 0; b < after.size(); ++b)
          within += count_rolls(map, before.layout(a), after.layout(b)) <= most ? 1 : 0;
        ASSERT_EQ(visited, within) << "seed " << seed << ", at most " << most;
      }
  }
}

}  // namespace
}  // namespace meshknit
