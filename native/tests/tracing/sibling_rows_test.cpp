// The order in which tubes that hang side by side are knit.

#include <gtest/gtest.h>

#include <algorithm>
#include <cstdlib>
#include <map>
#include <set>

#include "branching_graphs.h"
#include "graphs.h"
#include "meshknit/core/error.h"
#include "meshknit/knit_graph/rows.h"
#include "meshknit/tracing/event_order.h"
#include "meshknit/tracing/trace.h"
#include "meshknit/tracing/trace_checks.h"
#include "meshknit/tracing/tubes.h"

namespace meshknit {
namespace {

StitchTrace trace_cleanly(const KnitGraph& graph, int most_yarns = 9) {
  const StitchTrace trace = trace_knit_graph(graph, most_yarns);
  const Problems problems = check_trace(graph, trace);
  EXPECT_TRUE(problems.empty()) << problems.front().code << ": " << problems.front().message;
  return trace;
}

/// How many yarns are in use at the same time, from first to last stitch.
int most_yarns_in_use(const StitchTrace& trace) {
  std::map<int, std::pair<int, int>> uses;
  for (int s = 0; s < static_cast<int>(trace.stitches.size()); ++s) {
    const auto use = uses.try_emplace(trace.stitches[s].yarn, s, s).first;
    use->second.second = s;
  }
  int most = 0;
  for (int s = 0; s < static_cast<int>(trace.stitches.size()); ++s)
    most = std::max(
        most, static_cast<int>(std::count_if(uses.begin(), uses.end(), [&](const auto& use) {
          return use.second.first <= s && s <= use.second.second;
        })));
  return most;
}

TEST(SiblingRows, LegsGrowTogether) {
  // Three legs of 8 rows: none is ever more than a row (two stitches a node) ahead of another.
  const KnitGraph graph = three_legs(6, 6, 6, 8);
  const StitchTrace trace = trace_cleanly(graph);
  std::set<int> leg_tubes;
  const Tubes tubes = find_tubes(graph);
  for (int tube = 0; tube < tubes.count; ++tube)
    if (std::count(tubes.of_row.begin(), tubes.of_row.end(), tube) == 8) leg_tubes.insert(tube);
  ASSERT_EQ(leg_tubes.size(), 3u);
  std::map<int, int> stitches;
  int begun = 0;
  for (const Stitch& stitch : trace.stitches) {
    if (leg_tubes.count(stitch.tube) == 0) continue;
    begun += stitches[stitch.tube]++ == 0 ? 1 : 0;
    if (begun < 3) continue;
    const auto [least, most] =
        std::minmax_element(stitches.begin(), stitches.end(),
                            [](const auto& a, const auto& b) { return a.second < b.second; });
    // A row of a leg is 12 stitches; the first leg begins a row earlier.
    ASSERT_LE(most->second - least->second, 2 * 12);
  }
}

TEST(SiblingRows, NoYarnIsBroughtInToFinishARow) {
  for (const int seam : {0, 1, 3, 5, 7, 9, 11}) {
    // A trunk whose rows begin at different nodes, so that its yarn ends anywhere below the legs.
    GraphDrawing drawing;
    auto trunk = drawing.closed_row(drawing.cast_on(12), links(12), seam);
    auto left = drawing.closed_row({trunk.begin(), trunk.begin() + 5}, links(5));
    auto right = drawing.closed_row({trunk.begin() + 5, trunk.end()}, links(7));
    drawing.closed_row(left, links(5));
    drawing.closed_row(right, links(7));
    const KnitGraph graph = drawing.graph();
    const StitchTrace trace = trace_cleanly(graph);
    EXPECT_EQ(trace.yarns, 2);
    const RowWalk walk(graph);
    std::map<int, std::set<int>> yarns_of_row;
    for (const Stitch& stitch : trace.stitches)
      yarns_of_row[walk.place(stitch.node).row].insert(stitch.yarn);
    for (const auto& [row, yarns] : yarns_of_row)
      EXPECT_EQ(yarns.size(), 1u) << "row " << row << ", seam " << seam;
  }
}

TEST(SiblingRows, TheMiddleLegIsNotTheFirst) {
  // The leg that parts first hangs at a side; it is knit before the other two exist.
  const KnitGraph graph = three_legs(6, 6, 6, 4);
  const Tubes tubes = find_tubes(graph);
  const int trunk = tubes.of_row[0], rest = tubes.of_row[2], first_leg = tubes.of_row[3];
  std::vector<int> order;
  for (const Stitch& stitch : trace_cleanly(graph).stitches)
    if (std::count(order.begin(), order.end(), stitch.tube) == 0) order.push_back(stitch.tube);
  ASSERT_EQ(order.size(), 5u);
  EXPECT_EQ(std::set<int>(order.begin(), order.begin() + 3),
            (std::set<int>{trunk, rest, first_leg}));
}

TEST(SiblingRows, FewCarriersMeanFewYarnsAtATime) {
  for (const int most : {1, 2, 3}) {
    EXPECT_EQ(most_yarns_in_use(trace_cleanly(many_legs(5, 6, 4), most)), most);
    // No hole needs more than two.
    EXPECT_EQ(most_yarns_in_use(trace_cleanly(tube_with_hole(6, 6, 4), most)),
              std::min(most, 2));
  }
  EXPECT_EQ(most_yarns_in_use(trace_cleanly(many_legs(5, 6, 4), 9)), 5);
  EXPECT_THROW(trace_knit_graph(plain_tube(6, 3), 0), InvalidInput);
}

// A leg that waits for a yarn hangs between two others. Were they to meet first, they would cross it.
TEST(SiblingRows, ALegBetweenTwoOthersEndsBeforeTheyMeetHoweverFewTheYarns) {
  for (const int arches : {1, 2, 3}) {
    const KnitGraph graph = arches_over_legs(arches, 6, 3);
    for (const int most : {1, 2, 3, 4, 9}) {
      const StitchTrace trace = trace_cleanly(graph, most);
      EXPECT_FALSE(tubes_cross(graph, find_tubes(graph), trace)) << arches << ", " << most;
      EXPECT_LE(most_yarns_in_use(trace), most) << arches << " arches";
    }
  }
}

// The pair that meets first hangs between the other two until it ends, and yarns above a split are held
// meanwhile: still one yarn does, as it does for legs that start one after another and then meet.
TEST(SiblingRows, AnOrderWithoutCrossingsNeedsNoMoreYarnsThanLegByLeg) {
  for (const KnitGraph& graph :
       {crossed_pairs(6, 4, false), three_legs_upside_down(6, 6, 6, 4)}) {
    const StitchTrace trace = trace_cleanly(graph, 1);
    EXPECT_FALSE(tubes_cross(graph, find_tubes(graph), trace));
    EXPECT_EQ(most_yarns_in_use(trace), 1);
  }
}

TEST(SiblingRows, AStitchOnTheWrongTubeIsFound) {
  const KnitGraph graph = splitting_tube(6);
  StitchTrace trace = trace_cleanly(graph);
  trace.stitches.back().tube = 0;
  EXPECT_NE(find_problem(check_trace(graph, trace), "wrong-tube"), nullptr);
}

}  // namespace
}  // namespace meshknit
