#include "meshknit/tracing/hanging_order.h"

#include <gtest/gtest.h>

#include <set>

#include "branching_graphs.h"
#include "graphs.h"
#include "meshknit/tracing/tube_links.h"
#include "tracing/random_links.h"

namespace meshknit {
namespace {

using Verdict = HangingOrder::Verdict;

// Whether the tubes hang side by side all the way through the events, and nothing is left over.
bool can_be_followed(const std::vector<TubeLinks>& tubes,
                     const std::vector<TubeEvent>& events) {
  std::set<TubesOnBed> rows{{}};
  for (const TubeEvent& event : events) {
    std::set<TubesOnBed> next;
    for (const TubesOnBed& row : rows)
      for (const TubesOnBed& after : rows_after(tubes, row, event)) next.insert(after);
    rows = next;
  }
  return rows == std::set<TubesOnBed>{{}} && events.size() == events_in_time(tubes).size();
}

TEST(HangingOrder, IsFoundWheneverSomeOrderDoesNotCross) {
  int hang = 0, cross = 0;
  for (std::uint64_t seed = 0; seed < 2000; ++seed) {
    const std::vector<TubeLinks> tubes = random_links(seed, 12);
    const HangingOrder order = find_hanging_order(tubes);
    const bool possible = hang_in_some_order(tubes);
    ASSERT_EQ(order.verdict, possible ? Verdict::found : Verdict::none) << "seed " << seed;
    ASSERT_EQ(can_hang(tubes), possible);
    ASSERT_EQ(possible, can_be_followed(tubes, order.events)) << "seed " << seed;
    ++(possible ? hang : cross);
  }
  EXPECT_GT(hang, 500) << "both cases are tried";
  EXPECT_GT(cross, 100);
}

TEST(HangingOrder, PairsThatMeetCrosswiseHangOnlyOneAfterTheOther) {
  const KnitGraph apart = crossed_pairs(4, 3, false), joined = crossed_pairs(4, 3, true);
  EXPECT_TRUE(can_hang(link_tubes(apart, find_tubes(apart))));
  EXPECT_FALSE(can_hang(link_tubes(joined, find_tubes(joined))));
}

TEST(HangingOrder, ManyTubesAreNoTrouble) {
  // A trunk that sheds 39 legs has 79 tubes and as many events or more.
  const KnitGraph graph = many_legs(40, 4, 3);
  const std::vector<TubeLinks> tubes = link_tubes(graph, find_tubes(graph));
  ASSERT_EQ(tubes.size(), 79u);
  EXPECT_TRUE(can_be_followed(tubes, find_hanging_order(tubes).events));
}

}  // namespace
}  // namespace meshknit
