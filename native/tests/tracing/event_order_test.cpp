#include "meshknit/tracing/event_order.h"

#include <gtest/gtest.h>

#include <algorithm>

#include "branching_graphs.h"
#include "graphs.h"
#include "meshknit/tracing/trace.h"
#include "meshknit/tracing/trace_checks.h"

namespace meshknit {
namespace {

std::vector<TubeEvent> order_of(const KnitGraph& graph, int most_tubes = 9) {
  return find_event_order(graph, find_tubes(graph), most_tubes);
}

TEST(EventOrder, TheOrderOfTimeIsKeptWhereNothingCrosses) {
  EXPECT_TRUE(order_of(plain_tube(8, 4)).empty());
  EXPECT_TRUE(order_of(three_legs(6, 6, 6, 4)).empty());
  EXPECT_TRUE(order_of(tube_with_hole(6, 6, 4)).empty());
}

TEST(EventOrder, APairEndsBeforeTheTubesOnItsTwoSidesMeet) {
  const KnitGraph graph = crossed_pairs(4, 5, false);
  const std::vector<TubeEvent> order = order_of(graph);
  // The trunk starts and parts, both halves part, both pairs meet and end.
  ASSERT_EQ(order.size(), 8u);
  const auto find = [&](TubeEvent::Kind kind, int skip) {
    int at = 0;
    for (; order[at].kind != kind || skip-- > 0;) ++at;
    return at;
  };
  const int meets_second = find(TubeEvent::Kind::merge, 1);
  const int ends_first = find(TubeEvent::Kind::end, 0);
  EXPECT_EQ(order[ends_first].tube, order[find(TubeEvent::Kind::merge, 0)].tube);
  EXPECT_LT(ends_first, meets_second);

  // The trace keeps to it: the first pair is done before the second begins.
  const StitchTrace trace = trace_knit_graph(graph);
  EXPECT_TRUE(check_trace(graph, trace).empty());
  const int first = order[ends_first].tube, second = order[meets_second].tube;
  int last_of_first = -1, first_of_second = -1;
  for (int s = 0; s < static_cast<int>(trace.stitches.size()); ++s) {
    if (trace.stitches[s].tube == first) last_of_first = s;
    if (trace.stitches[s].tube == second && first_of_second < 0) first_of_second = s;
  }
  EXPECT_LT(last_of_first, first_of_second);
}

TEST(EventOrder, FewTubesHangAtOnceWhereFewCarriersAreFree) {
  // A trunk that sheds five legs while all of them grow: in the order of time six tubes hang at once.
  const KnitGraph graph = many_legs(6, 6, 12);
  EXPECT_TRUE(order_of(graph).empty());
  for (const int most : {2, 3, 4}) {
    const std::vector<TubeEvent> order = order_of(graph, most);
    ASSERT_FALSE(order.empty());
    int hanging = 0;
    for (const TubeEvent& event : order) {
      if (event.kind == TubeEvent::Kind::start || event.kind == TubeEvent::Kind::split)
        ++hanging;
      if (event.kind == TubeEvent::Kind::merge || event.kind == TubeEvent::Kind::end) --hanging;
      EXPECT_LE(hanging, most);
    }
    EXPECT_EQ(hanging, 0);
    EXPECT_TRUE(check_trace(graph, trace_knit_graph(graph, most)).empty());
  }
  // A trunk that parts cannot hang alone.
  EXPECT_TRUE(order_of(graph, 1).empty());
}

TEST(EventOrder, NoneIsFoundWhereAllOrdersCross) {
  EXPECT_TRUE(order_of(crossed_pairs(4, 3, true)).empty());
}

}  // namespace
}  // namespace meshknit
