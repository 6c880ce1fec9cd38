#include <gtest/gtest.h>

#include "graphs.h"
#include "meshknit/knit_graph/closed_row_links.h"
#include "meshknit/knit_graph/knit_graph_checks.h"
#include "meshknit/knit_graph/split_layout.h"

namespace meshknit {
namespace {

TEST(ClosedRowLinks, ShortRowsBelongToTheRowBelowThem) {
  const KnitGraph graph = nested_short_rows();  // row 0 closed, 1-3 short, 4 and 5 closed
  const RowWalk walk(graph);
  const ClosedRowLinks links = link_closed_rows(graph, walk);
  EXPECT_EQ(links.above[0], std::vector<int>{4});
  EXPECT_EQ(links.below[3], std::vector<int>{0});
  EXPECT_EQ(links.below[4], std::vector<int>{0});
  EXPECT_FALSE(links.is_split(0)) << "a tube with short rows does not branch";
}

TEST(Splits, TrousersSplitOnceAndMergeUpsideDown) {
  for (const int n : {3, 4, 7, 20}) {
    EXPECT_TRUE(check_knit_graph(splitting_tube(n)).problems.empty()) << n;
    EXPECT_TRUE(check_knit_graph(merging_tube(n)).problems.empty()) << n;
    EXPECT_EQ(measure_graph(splitting_tube(n)).splits, 1);
    EXPECT_EQ(measure_graph(splitting_tube(n)).merges, 0);
    EXPECT_EQ(measure_graph(merging_tube(n)).splits, 0);
    EXPECT_EQ(measure_graph(merging_tube(n)).merges, 1);
  }
}

TEST(Splits, NoShapingAtASplit) {
  GraphDrawing drawing;
  const auto trunk = drawing.cast_on(12);
  drawing.closed_row({trunk.begin(), trunk.begin() + 6}, "Y|||||");
  drawing.closed_row({trunk.begin() + 6, trunk.end()}, "||||||");
  const Problems problems = check_simple_splits(drawing.graph());
  ASSERT_EQ(problems.size(), 2u) << "both columns of the increase";
  EXPECT_EQ(problems[0].code, "property-5-shaping-at-split");
}

TEST(Splits, NoShortRowAcrossASplitOrMerge) {
  GraphDrawing split;
  auto trunk = split.cast_on(12);
  trunk = split.short_row(trunk, 4, "||||");
  split.closed_row({trunk.begin(), trunk.begin() + 6}, "||||||");
  split.closed_row({trunk.begin() + 6, trunk.end()}, "||||||");
  EXPECT_NE(find_problem(check_simple_splits(split.graph()), "property-5-short-row-at-split"),
            nullptr);

  GraphDrawing merge;
  auto left = merge.cast_on(6), right = merge.cast_on(6);
  left.insert(left.end(), right.begin(), right.end());
  left = merge.short_row(left, 4, "||||");
  merge.closed_row(left, links(12));
  const Problems problems = check_simple_splits(merge.graph());
  EXPECT_NE(find_problem(problems, "property-5-short-row-at-merge"), nullptr);
  EXPECT_NE(find_problem(problems, "property-5-short-row-at-merge")->elements.nodes.size(), 0u);
}

TEST(Splits, AShortRowBesideASplitIsAllowed) {
  GraphDrawing drawing;
  auto trunk = drawing.cast_on(12);
  trunk = drawing.short_row(trunk, 2, "||||");
  trunk = drawing.closed_row(trunk, links(12));
  drawing.closed_row({trunk.begin(), trunk.begin() + 6}, "||||||");
  auto right = drawing.closed_row({trunk.begin() + 6, trunk.end()}, "||||||");
  right = drawing.short_row(right, 1, "|||");
  drawing.closed_row(right, "||||||");
  EXPECT_TRUE(check_knit_graph(drawing.graph()).problems.empty());
}

TEST(Splits, TheMiddleOfThreeTubesNeedsEqualSides) {
  // The middle tube's loops hang in the middle of both beds. With a on the left and c on the
  // right, its b1 and b2 loops may differ by two at most: a tube of n loops has n/2 and n/2 or,
  // at worst, one more in front and one less behind.
  EXPECT_TRUE(check_feasible_splits(three_way_split(6, 4, 6, 4)).empty());
  EXPECT_TRUE(check_feasible_splits(three_way_split(6, 5, 6, 3)).empty());
  const Problems problems = check_feasible_splits(three_way_split(6, 7, 6, 1));
  ASSERT_EQ(problems.size(), 1u);
  EXPECT_EQ(problems[0].code, "property-6-no-layout");
  // 20 loops of the row that splits, and the rows of 6, 8 and 6 above it.
  EXPECT_EQ(problems[0].elements.nodes.size(), 40u);
}

TEST(SplitLayout, SideBySideHangsButInsideOutDoesNot) {
  EXPECT_TRUE(has_common_layout({{0, 1, 2, 3, 4, 5}, {0, 1, 2}, {3, 4, 5}}));
  EXPECT_FALSE(has_common_layout({{0, 1, 2, 3, 4, 5}, {2, 1, 0}, {3, 4, 5}}))
      << "a cycle cannot be turned round";
  EXPECT_FALSE(has_common_layout({{0, 1, 2, 3, 4, 5}, {0, 2, 4}, {1, 3, 5}}))
      << "tubes that interleave stretch their yarn";
}

TEST(SplitLayout, TwoTubesMayMergeAndPartInOneRow) {
  // Below, tubes of 0-7 and of 8-11 side by side; above, 0-3 on the left and the rest on the
  // right, which has the second tube's loops between its own 5 and 6.
  EXPECT_TRUE(has_common_layout(
      {{0, 1, 2, 3, 4, 5, 6, 7}, {8, 9, 10, 11}, {0, 1, 2, 3}, {4, 5, 8, 9, 10, 11, 6, 7}}));
}

TEST(SplitLayout, TwoLoopsDoNotShareANeedle) {
  // The tube of 3-5 and 6-8 would have to go on from 5 with 6 where the lower tube goes on from
  // 5 with 0.
  EXPECT_FALSE(
      has_common_layout({{0, 1, 2, 3, 4, 5}, {6, 7, 8}, {0, 1, 2}, {3, 4, 5, 6, 7, 8}}));
}

}  // namespace
}  // namespace meshknit
