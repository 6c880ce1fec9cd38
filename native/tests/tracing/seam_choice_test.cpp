#include "meshknit/tracing/seam_choice.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <tuple>

#include "branching_graphs.h"
#include "graphs.h"
#include "meshknit/tracing/hanging_order.h"
#include "meshknit/tracing/tube_links.h"
#include "tracing/random_links.h"

namespace meshknit {
namespace {

using Set = std::vector<int>;

// The best of all sets of tubes, those that start or end the object among them.
std::tuple<std::size_t, int> least_of_all(const std::vector<TubeLinks>& tubes,
                                          const std::vector<int>& stitches) {
  std::tuple<std::size_t, int> least{1000, 0};
  for (std::size_t size = 1; size <= std::min(tubes.size(), std::get<0>(least)); ++size)
    for (unsigned bits = 0; bits < 1u << tubes.size(); ++bits) {
      Set set;
      int sum = 0;
      for (int tube = 0; tube < static_cast<int>(tubes.size()); ++tube) {
        if ((bits >> tube & 1) == 0) continue;
        set.push_back(tube);
        sum += stitches[tube] > 0 ? stitches[tube] : 1000000;  // cannot be cut
      }
      const std::tuple<std::size_t, int> cost{set.size(), sum};
      if (set.size() == size && sum < 1000000 && cost < least &&
          hang_in_some_order(cut_tubes(tubes, set)))
        least = cost;
    }
  return least;
}

TEST(SeamChoice, IsTheSmallestOfAllSets) {
  int sewn = 0, two = 0;
  for (std::uint64_t seed = 0; seed < 200; ++seed) {
    const std::vector<TubeLinks> tubes = random_links(seed, 12);
    Dice dice(seed + 1000);
    std::vector<int> stitches;
    for (std::size_t t = 0; t < tubes.size(); ++t) stitches.push_back(dice.roll(9));
    const SeamChoice choice = choose_seams(tubes, stitches);
    ASSERT_EQ(choice.needed, !hang_in_some_order(tubes)) << "seed " << seed;
    if (!choice.needed) {
      EXPECT_TRUE(choice.tubes.empty());
      continue;
    }
    const auto [count, sum] = least_of_all(tubes, stitches);
    if (choice.tubes.empty()) {
      EXPECT_EQ(count, 1000u) << "seed " << seed << ": something helps";
      continue;
    }
    int own = 0;
    for (const int tube : choice.tubes) own += stitches[tube];
    ASSERT_EQ(choice.tubes.size(), count) << "seed " << seed;
    ASSERT_EQ(own, sum) << "seed " << seed;
    EXPECT_TRUE(can_hang(cut_tubes(tubes, choice.tubes)));
    ++sewn;
    two += count > 1;
  }
  EXPECT_GT(sewn, 10);
  EXPECT_GT(two, 0);
}

// Two pairs meet crosswise: any of the four tubes can be the one that waits.
TEST(SeamChoice, CutsTheNarrowestOfTheTubesThatCross) {
  const KnitGraph graph = crossed_pairs(4, 3, true);
  const std::vector<TubeLinks> tubes = link_tubes(graph, find_tubes(graph));
  std::vector<int> crossing;
  for (int t = 0; t < static_cast<int>(tubes.size()); ++t)
    if (!tubes[t].below.empty() && !tubes[t].above.empty() && tubes[t].above.size() == 1 &&
        tubes[tubes[t].below[0]].above.size() == 2 &&
        tubes[tubes[t].above[0]].above.size() == 1)
      crossing.push_back(t);
  ASSERT_EQ(crossing.size(), 4u);
  for (const int narrow : crossing) {
    std::vector<int> stitches(tubes.size(), 20);
    stitches[narrow] = 19;
    EXPECT_EQ(choose_seams(tubes, stitches).tubes, Set{narrow});
  }
}

// Such shapes one on top of another need a seam each; three have more than twelve tubes to cut.
TEST(SeamChoice, EachOfSeveralCrossingsGetsItsSeam) {
  const KnitGraph graph = crossed_pairs(4, 3, true);
  const std::vector<TubeLinks> one = link_tubes(graph, find_tubes(graph));
  const int count = static_cast<int>(one.size());
  for (int stories = 1; stories <= 3; ++stories) {
    std::vector<TubeLinks> tubes;
    for (int story = 0; story < stories; ++story)
      for (TubeLinks links : one) {
        for (std::vector<int>* others : {&links.below, &links.above})
          for (int& other : *others) other += story * count;
        links.begin += 100.0 * story;
        links.end += 100.0 * story;
        tubes.push_back(links);
      }
    for (int story = 1; story < stories; ++story) {
      // The last tube below and the first above are one and the same; a tube of two pieces would
      // need an event between them, so the upper trunk parts off a bud.
      const int trunk = story * count - 1, next = story * count;
      const int bud = static_cast<int>(tubes.size());
      tubes[trunk].above = {next, bud};
      tubes[next].below = {trunk};
      tubes.push_back({{trunk}, {}, tubes[next].begin, tubes[next].end});
    }
    const std::vector<int> stitches(tubes.size(), 10);
    const SeamChoice choice = choose_seams(tubes, stitches);
    EXPECT_EQ(choice.tubes.size(), static_cast<std::size_t>(stories));
    EXPECT_TRUE(hang_in_some_order(cut_tubes(tubes, choice.tubes)));
  }
}

TEST(SeamChoice, SaysSoIfNoTubeCanBeCut) {
  const KnitGraph graph = crossed_pairs(4, 3, true);
  const std::vector<TubeLinks> tubes = link_tubes(graph, find_tubes(graph));
  const SeamChoice choice = choose_seams(tubes, std::vector<int>(tubes.size(), 0));
  EXPECT_TRUE(choice.needed);
  EXPECT_TRUE(choice.tubes.empty());
}

}  // namespace
}  // namespace meshknit
