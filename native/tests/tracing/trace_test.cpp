#include "meshknit/tracing/trace.h"

#include <gtest/gtest.h>

#include <algorithm>

#include "bed_picture.h"
#include "graphs.h"
#include "meshknit/core/error.h"
#include "meshknit/knit_graph/knit_graph_checks.h"
#include "meshknit/tracing/trace_checks.h"

namespace meshknit {
namespace {

StitchTrace trace_cleanly(const KnitGraph& graph) {
  const StitchTrace trace = trace_knit_graph(graph);
  const Problems problems = check_trace(graph, trace);
  EXPECT_TRUE(problems.empty()) << problems.front().code << ": " << problems.front().message
                                << "\n"
                                << bed_picture(trace);
  EXPECT_EQ(trace.yarns, 1);
  return trace;
}

int count_kind(const StitchTrace& trace, StitchKind kind) {
  return static_cast<int>(std::count_if(trace.stitches.begin(), trace.stitches.end(),
                                        [&](const Stitch& s) { return s.kind == kind; }));
}

/// Nodes in the order in which they are knit; tucks are left out.
std::vector<int> nodes_in_order(const StitchTrace& trace) {
  std::vector<int> nodes;
  for (const Stitch& stitch : trace.stitches)
    if (stitch.kind != StitchKind::tuck) nodes.push_back(stitch.node);
  return nodes;
}

TEST(Trace, APlainTubeIsASpiralOfTwoRoundsARow) {
  for (const int n : {3, 4, 7, 30}) {
    for (const int rows : {1, 2, 6}) {
      const StitchTrace trace = trace_cleanly(plain_tube(n, rows));
      ASSERT_EQ(static_cast<int>(trace.stitches.size()), 2 * n * rows);
      EXPECT_EQ(trace.courses, 2 * rows);
      EXPECT_EQ(count_kind(trace, StitchKind::start), n);
      EXPECT_EQ(count_kind(trace, StitchKind::end), n);
      // One loop round the tube further with every stitch: stitch i knits through stitch i - n.
      for (int i = n; i < 2 * n * rows; ++i)
        EXPECT_EQ(trace.stitches[i].parents, std::vector<int>{i - n});
    }
  }
}

TEST(Trace, AnIncreaseIsMadeInTheSecondRoundAndADecreaseInTheFirst) {
  const StitchTrace trace = trace_cleanly(shaped_tube(6, {"||Y|||", "|||A||"}));
  EXPECT_EQ(count_kind(trace, StitchKind::increase), 1);
  EXPECT_EQ(count_kind(trace, StitchKind::decrease), 1);
  // Round 1 is stitches 0-5, so node 2's second stitch is 8.
  const Stitch& increase = trace.stitches[8];
  EXPECT_EQ(increase.kind, StitchKind::increase);
  ASSERT_EQ(increase.children.size(), 2u);
  // Anticlockwise the knit loop comes first, its child is the left one of nodes 8 and 9 (6 + 2,
  // 6 + 3).
  EXPECT_EQ(trace.stitches[increase.children[0]].node, 8);
  EXPECT_EQ(trace.stitches[increase.children[1]].node, 9);
  const auto decrease =
      std::find_if(trace.stitches.begin(), trace.stitches.end(),
                   [](const Stitch& s) { return s.kind == StitchKind::decrease; });
  EXPECT_LT(trace.stitches[decrease->parents[0]].node,
            trace.stitches[decrease->parents[1]].node);
}

TEST(Trace, ShapingWhereTheYarnGoesUpARow) {
  // The first row's yarn ends at its last node, so a row's last links lie where yarn goes up.
  for (const std::string row : {"|||||Y", "Y|||||", "||||A", "A||||", "Y|||A", "A|||Y"})
    for (const std::string next : {"|", "Y", "A"}) {
      KnitGraph graph = shaped_tube(6, {row});
      const int n = static_cast<int>(graph.rows[1].nodes.size());
      const std::string rest = links(n - (next == "A" ? 2 : 1));
      trace_cleanly(shaped_tube(6, {row, rest + next,
                                    links(next == "Y"   ? n + 1
                                          : next == "A" ? n - 1
                                                        : n)}));
    }
}

TEST(Trace, AShortRowIsKnitThereAndBackWithATuckAtEachEnd) {
  // Nodes 0-9 round, 10-13 over 3-6. The second round makes the short row ready at node 6; the
  // yarn tucks on 7, knits 13..10 back, tucks on 2, knits 10..13 and goes on with 7.
  const StitchTrace trace = trace_cleanly(one_short_row());
  const std::vector<int> nodes = nodes_in_order(trace);
  const std::vector<int> part(nodes.begin() + 16, nodes.begin() + 26);
  EXPECT_EQ(part, (std::vector<int>{6, 13, 12, 11, 10, 10, 11, 12, 13, 7}));

  ASSERT_EQ(count_kind(trace, StitchKind::tuck), 2);
  const Stitch &first = trace.stitches[17], &second = trace.stitches[22];
  ASSERT_EQ(first.kind, StitchKind::tuck);
  ASSERT_EQ(second.kind, StitchKind::tuck);
  EXPECT_EQ(first.node, 7);
  EXPECT_EQ(first.direction, Direction::anticlockwise);
  EXPECT_EQ(second.node, 2);
  EXPECT_EQ(second.direction, Direction::clockwise);
  // Node 7 has only been knit once: its second stitch picks up the tuck. Node 2 is done: the
  // stitch above does.
  EXPECT_EQ(trace.stitches[first.children[0]].node, 7);
  EXPECT_EQ(trace.stitches[first.children[0]].parents, (std::vector<int>{7, 17}));
  EXPECT_EQ(trace.stitches[second.children[0]].node, 16);  // 14 + 2
}

TEST(Trace, AShortRowOverTheSeamBeginsInItsMiddle) {
  // Nodes 10-14 over 8 9 0 1 2. The last round ends at 9, below 11: the yarn goes on with 12.
  const StitchTrace trace = trace_cleanly(short_row_over_seam());
  const std::vector<int> nodes = nodes_in_order(trace);
  const std::vector<int> part(nodes.begin() + 20, nodes.begin() + 30);
  EXPECT_EQ(part, (std::vector<int>{12, 13, 14, 14, 13, 12, 11, 10, 10, 11}));
  EXPECT_EQ(count_kind(trace, StitchKind::tuck), 2);
}

TEST(Trace, ShortRowsAnywhereRoundTheTube) {
  for (int begin = 0; begin < 9; ++begin)
    for (int width = 1; width <= 9; ++width) {
      const StitchTrace trace = trace_cleanly(tube_with_short_rows(9, {{begin, links(width)}}));
      EXPECT_EQ(count_kind(trace, StitchKind::tuck), 2) << begin << " " << width;
    }
}

TEST(Trace, TwoShortRowsAnywhereRoundTheTube) {
  for (int begin = 0; begin < 7; ++begin)
    for (int width = 2; width <= 6; ++width)
      for (int second = 0; second < 7; ++second)
        for (int second_width = 2; second_width <= 6; ++second_width)
          trace_cleanly(
              tube_with_short_rows(7, {{begin, links(width)}, {second, links(second_width)}}));
}

TEST(Trace, NestedShortRowsAndIncreasesInThem) {
  EXPECT_EQ(count_kind(trace_cleanly(nested_short_rows()), StitchKind::tuck), 6);
  trace_cleanly(short_row_with_increase());
  // A short row over the seam, nodes 10-15 over 8 9 0 1 2 3, is finished clockwise from 15
  // to 12. The increase above 13 is made on that way.
  const StitchTrace trace =
      trace_cleanly(tube_with_short_rows(10, {{8, "||||||"}, {9, "||Y||"}}));
  EXPECT_TRUE(std::any_of(trace.stitches.begin(), trace.stitches.end(), [](const Stitch& s) {
    return s.kind == StitchKind::increase && s.direction == Direction::clockwise;
  }));
}

TEST(Trace, EndsAboveEndsTuckOnTheLoopThatHangsBesideThem) {
  // All k short rows end between the same neighbours: the loop of node 7 gets k tucks and is
  // knit with all of them.
  for (const int k : {2, 3, 5}) {
    const StitchTrace trace = trace_cleanly(stacked_short_rows(k));
    int on_seven = 0;
    for (const Stitch& stitch : trace.stitches)
      on_seven += stitch.kind == StitchKind::tuck && stitch.node == 7;
    EXPECT_EQ(on_seven, k);
  }
}

TEST(Trace, RandomTubes) {
  for (int seed = 0; seed < 300; ++seed) {
    SCOPED_TRACE(seed);
    const KnitGraph graph = random_tube(seed);
    const StitchTrace trace = trace_cleanly(graph);
    EXPECT_EQ(count_kind(trace, StitchKind::tuck), 2 * measure_graph(graph).short_rows);
    if (HasFailure()) break;
  }
}

TEST(Trace, BadGraphsAreRefusedWithTheirProperty) {
  const auto code = [](const KnitGraph& graph) -> std::string {
    try {
      trace_knit_graph(graph);
    } catch (const NotKnittable& error) {
      return error.problems().front().code;
    }
    return "";
  };
  EXPECT_EQ(code(helix()), "property-2-helix");
  EXPECT_EQ(code(flipped_row()), "property-1-reversed-row");
}

TEST(Trace, CanBeCancelled) {
  RunContext run;
  run.cancel();
  EXPECT_THROW(trace_knit_graph(plain_tube(6, 3), &run), Cancelled);
  RunContext whole;
  whole.begin_stage(0.0, 1.0);
  trace_knit_graph(plain_tube(6, 3), &whole);
  EXPECT_DOUBLE_EQ(whole.progress(), 1.0);
}

}  // namespace
}  // namespace meshknit
