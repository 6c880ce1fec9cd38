#include <gtest/gtest.h>

#include <algorithm>

#include "graphs.h"
#include "meshknit/knit_graph/knit_graph_checks.h"

namespace meshknit {
namespace {

TEST(Orientation, ARowListedBackwardsIsFoundOnBothOfItsSides) {
  const Problems problems = check_consistent_orientation(flipped_row());
  // Six pairs of neighbours below the flipped row and six on it all run against each other.
  EXPECT_EQ(problems.size(), 12u);
  EXPECT_EQ(problems.front().code, "property-1-reversed-row");
}

TEST(Orientation, IncreasesInTheSmallestTubesAreNoReversal) {
  // Round three or four nodes the far ends of an increase and its neighbour's nodes meet.
  EXPECT_TRUE(check_consistent_orientation(shaped_tube(3, {"YA"})).empty());
  EXPECT_TRUE(check_consistent_orientation(shaped_tube(4, {"YYA"})).empty());
}

TEST(Orientation, AFlippedRowOfIncreasesIsFound) {
  KnitGraph graph = shaped_tube(6, {links(6, 'Y')});
  std::reverse(graph.rows[1].nodes.begin(), graph.rows[1].nodes.end());
  EXPECT_FALSE(check_consistent_orientation(graph).empty());
}

TEST(HelixFree, ARowThatStandsOnItselfIsAHelix) {
  const Problems problems = check_helix_free(helix());
  ASSERT_EQ(problems.size(), 1u);
  EXPECT_EQ(problems[0].code, "property-2-helix");
  EXPECT_EQ(problems[0].elements.nodes.size(), 18u) << "all nodes of the winding row";
}

TEST(HelixFree, OnlyTheRowsOfTheCycleAreNamed) {
  GraphDrawing drawing;
  auto front = drawing.cast_on(6);
  for (int i = 0; i < 4; ++i) front = drawing.closed_row(front, links(6));
  // From row 3 back into row 2; row 4 above and rows 0 and 1 below are innocent.
  drawing.add_column(drawing.row(3).nodes[5], drawing.row(2).nodes[0]);
  const Problems problems = check_helix_free(drawing.graph());
  ASSERT_EQ(problems.size(), 1u);
  std::vector<int> wanted = drawing.row(2).nodes;
  wanted.insert(wanted.end(), drawing.row(3).nodes.begin(), drawing.row(3).nodes.end());
  EXPECT_EQ(problems[0].elements.nodes, wanted);
}

TEST(HelixFree, TwoHelicesAreTwoProblems) {
  GraphDrawing drawing;
  auto front = drawing.cast_on(6);
  for (int i = 0; i < 5; ++i) front = drawing.closed_row(front, links(6));
  drawing.add_column(drawing.row(2).nodes[5], drawing.row(1).nodes[0]);
  drawing.add_column(drawing.row(4).nodes[5], drawing.row(3).nodes[0]);
  EXPECT_EQ(check_helix_free(drawing.graph()).size(), 2u);
}

TEST(HelixFree, RowsAreListedInTheOrderOfMaking) {
  KnitGraph graph = plain_tube(6, 3);
  std::swap(graph.rows[1], graph.rows[2]);
  const Problems problems = check_helix_free(graph);
  EXPECT_NE(find_problem(problems, "property-2-row-order"), nullptr);
  EXPECT_EQ(find_problem(problems, "property-2-helix"), nullptr);
}

TEST(NodeDegree, ThreeLoopsFromOneStitchAreTooMany) {
  GraphDrawing drawing;
  const auto front = drawing.cast_on(6);
  drawing.closed_row(front, "Y|||||");
  drawing.add_column(0, drawing.row(1).nodes[2]);  // node 0 has the increase's two already
  const Problems problems = check_node_degree(drawing.graph());
  ASSERT_EQ(problems.size(), 1u);
  EXPECT_EQ(problems[0].code, "property-3-too-many-above");
  EXPECT_EQ(problems[0].elements.nodes, std::vector<int>{0});
}

TEST(NodeDegree, ThreeLoopsInOneStitchAreTooMany) {
  GraphDrawing drawing;
  const auto front = drawing.cast_on(6);
  drawing.closed_row(front, "A||||");
  drawing.add_column(2, drawing.row(1).nodes[0]);
  EXPECT_NE(find_problem(check_node_degree(drawing.graph()), "property-3-too-many-below"),
            nullptr);
}

TEST(NodeDegree, ALoopIsNotLeftBehindInTheMiddle) {
  KnitGraph graph = plain_tube(6, 3);
  graph.columns.erase(graph.columns.begin());  // from node 0 to node 6
  graph.column_lengths.pop_back();
  const Problems problems = check_node_degree(graph);
  ASSERT_EQ(problems.size(), 2u) << "a loop left over, and a node that begins on nothing";
  EXPECT_EQ(problems[0].elements.nodes, std::vector<int>{0});
  EXPECT_EQ(problems[1].elements.nodes, std::vector<int>{6});
}

TEST(ShortRows, NoShapingAtTheirEnds) {
  EXPECT_TRUE(check_simple_short_rows(tube_with_short_rows(10, {{3, "|YA|"}})).empty());
  // The row's last node is a decrease; the tube above still has one node for each.
  const Problems problems = check_simple_short_rows(tube_with_short_rows(10, {{3, "||A"}}));
  ASSERT_EQ(problems.size(), 1u);
  EXPECT_EQ(problems[0].code, "property-4-row-end");
  EXPECT_EQ(problems[0].elements.nodes, std::vector<int>{12})
      << "10 nodes below, third of the row";
}

TEST(ShortRows, NoDecreaseOverTheStepAtTheirEnd) {
  GraphDrawing drawing;
  auto front = drawing.cast_on(10);
  front = drawing.short_row(front, 3, "||||");
  // Front: 0 1 2, the short row's 10..13, 7 8 9. The decrease joins 13 and 7.
  drawing.closed_row(front, "||||||A||");
  const Problems problems = check_simple_short_rows(drawing.graph());
  ASSERT_EQ(problems.size(), 1u);
  EXPECT_EQ(problems[0].code, "property-4-shaping-across-rows");
}

TEST(TimeAligned, FallingColumnsAndSteepRowsAreWarnings) {
  KnitGraph graph = plain_tube(6, 5);  // columns climb by 2 / 4
  EXPECT_TRUE(check_time_aligned(graph).empty());
  KnitGraph falling = graph;
  falling.nodes[6].time = -1.1;  // above node 0, whose time is -1
  EXPECT_NE(find_problem(check_time_aligned(falling), "property-7-falling-column"), nullptr);
  KnitGraph steep = graph;
  steep.nodes[14].time += 0.6;
  const Problems problems = check_time_aligned(steep);
  EXPECT_NE(find_problem(problems, "property-7-steep-row"), nullptr);
  EXPECT_FALSE(has_errors(problems));
}

}  // namespace
}  // namespace meshknit
