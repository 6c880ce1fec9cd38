// Stitches that are put into a finished graph.

#include "meshknit/knit_graph/insert_stitches.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <array>

#include "branching_graphs.h"
#include "graphs.h"
#include "meshknit/knit_graph/knit_graph_checks.h"
#include "meshknit/tracing/trace.h"
#include "meshknit/tracing/trace_checks.h"

namespace meshknit {
namespace {

// The edited graph with what editing does not know: sizes as wanted, and each row's time by its number.
KnitGraph finished(const EditableGraph& editable) {
  std::vector<int> number_of;
  KnitGraph graph = editable.graph(number_of);
  const double rows = static_cast<double>(graph.rows.size());
  for (std::size_t r = 0; r < graph.rows.size(); ++r) {
    const KnitRow& row = graph.rows[r];
    graph.row_lengths.emplace_back(row.nodes.size() - !row.closed, graph.stitch_width);
    for (const int node : row.nodes)
      graph.nodes[node] = {Eigen::Vector3d::Zero(), 2.0 * static_cast<double>(r) / rows - 1.0};
  }
  graph.column_lengths.assign(graph.columns.size(), 2.0 * graph.stitch_height);
  return graph;
}

void expect_same_stitches(const KnitGraph& a, const KnitGraph& b) {
  EXPECT_EQ(a.columns, b.columns);
  ASSERT_EQ(a.rows.size(), b.rows.size());
  for (std::size_t r = 0; r < a.rows.size(); ++r) {
    EXPECT_EQ(a.rows[r].nodes, b.rows[r].nodes) << "row " << r;
    EXPECT_EQ(a.rows[r].closed, b.rows[r].closed) << "row " << r;
  }
}

std::vector<KnitGraph> drawn_graphs() {
  std::vector<KnitGraph> graphs = {
      plain_tube(12, 5), nested_short_rows(), short_row_over_seam(),  short_row_with_increase(),
      splitting_tube(6), merging_tube(6),     three_legs(6, 8, 6, 5), tube_with_hole(8, 10, 6)};
  for (std::uint64_t seed = 0; seed < 30; ++seed) graphs.push_back(random_tube(seed));
  return graphs;
}

TEST(EditableGraph, NumbersNodesRowByRowAndLeavesTheirColumns) {
  for (const KnitGraph& graph : drawn_graphs()) {
    std::vector<int> number_of;
    const KnitGraph same = EditableGraph(graph).graph(number_of);
    ASSERT_EQ(same.rows.size(), graph.rows.size());
    int number = 0;
    for (std::size_t r = 0; r < graph.rows.size(); ++r) {
      EXPECT_EQ(same.rows[r].closed, graph.rows[r].closed);
      std::vector<int> nodes;
      for (const int node : same.rows[r].nodes) {
        EXPECT_EQ(node, number++);
        nodes.push_back(number_of[node]);
      }
      EXPECT_EQ(nodes, graph.rows[r].nodes);
    }
    std::vector<std::array<int, 2>> columns;
    for (const auto& [from, to] : same.columns)
      columns.push_back({number_of[from], number_of[to]});
    std::stable_sort(columns.begin(), columns.end(),
                     [](const auto& a, const auto& b) { return a[0] < b[0]; });
    EXPECT_EQ(columns, graph.columns);
  }
}

TEST(EditableGraph, TakesAChangeBack) {
  const KnitGraph graph = plain_tube(12, 5);
  EditableGraph editable(graph);
  ASSERT_EQ(insert_short_row(editable, 14, 5).size(), 5u);
  const KnitGraph with_row = finished(editable);
  editable.begin_change();
  ASSERT_EQ(insert_wale(editable, 33, 2, Beside::previous, Beside::next).size(), 2u);
  EXPECT_NE(finished(editable).columns, with_row.columns);
  editable.undo_change();
  expect_same_stitches(finished(editable), with_row);
}

TEST(InsertShortRow, IsTheRowThatOneWouldHaveKnit) {
  // Rows 0 and 1 of 12 nodes; row 1's third to sixth node carry a row of 4.
  EditableGraph editable(plain_tube(12, 4));
  EXPECT_EQ(insert_short_row(editable, 14, 4).size(), 4u);
  GraphDrawing drawing;
  auto front = drawing.closed_row(drawing.cast_on(12), links(12));
  front = drawing.short_row(front, 2, links(4));
  front = drawing.closed_row(front, links(12));
  drawing.closed_row(front, links(12));
  expect_same_stitches(finished(editable), drawing.graph());
}

TEST(InsertShortRow, KeepsTheShapingThatItGoesUnder) {
  // The increase over node 14 is knit from the short row then.
  EditableGraph editable(shaped_tube(12, {links(12), "||Y|||||||||", links(13)}));
  const std::vector<int> added = insert_short_row(editable, 13, 4);
  ASSERT_EQ(added.size(), 4u);
  EXPECT_EQ(editable.links(14, Side::above).size(), 1);
  EXPECT_EQ(editable.links(added[1], Side::above).size(), 2);
  EXPECT_FALSE(has_errors(check_knit_graph(finished(editable)).problems));
}

TEST(InsertShortRow, KeepsAwayFromWhatATurnDisturbs) {
  EditableGraph shaped(shaped_tube(12, {links(12), "||Y|||||||||", links(13)}));
  EXPECT_TRUE(insert_short_row(shaped, 14, 4).empty()) << "would turn below the increase";
  EXPECT_TRUE(insert_short_row(shaped, 15, 4).empty()) << "would turn beside it";
  EXPECT_FALSE(insert_short_row(shaped, 16, 4).empty());

  EditableGraph plain(plain_tube(12, 4));
  EXPECT_TRUE(insert_short_row(plain, 14, 2).empty()) << "two stitches are no row";
  EXPECT_TRUE(insert_short_row(plain, 14, 10).empty()) << "its turns would meet";
  EXPECT_TRUE(insert_short_row(plain, 38, 4).empty()) << "nothing is above the last row";
  EXPECT_EQ(insert_short_row(plain, 14, 9).size(), 9u);
  EXPECT_TRUE(insert_short_row(plain, 26, 4).empty()) << "turns would lie above turns";
}

TEST(InsertShortRow, LeavesSplitsAndMergesAlone) {
  // Rows 0 to 2 are the trunk: 12 nodes each.
  EditableGraph trousers(splitting_tube(6));
  EXPECT_TRUE(insert_short_row(trousers, 26, 3).empty());
  EXPECT_FALSE(insert_short_row(trousers, 14, 3).empty());
  // Upside down the last rows of two legs of 6 meet in a row of 12.
  EditableGraph merging(merging_tube(6));
  int meeting = 0;
  for (int node = 0; node < merging.size(); ++node) {
    const int above = merging.links(node, Side::above).front();
    if (above < 0 ||
        merging.row_size(merging.row(above)) == merging.row_size(merging.row(node)))
      continue;
    ++meeting;
    EXPECT_TRUE(insert_short_row(merging, node, 3).empty());
    EXPECT_TRUE(insert_wale(merging, node, 1, Beside::next, Beside::next).empty());
  }
  EXPECT_EQ(meeting, 12);
}

TEST(InsertWale, IsTheWaleThatOneWouldHaveKnit) {
  // Rows of 8; the new wale stands left of the third node of rows 2 and 3.
  EditableGraph editable(plain_tube(8, 6));
  EXPECT_EQ(insert_wale(editable, 18, 2, Beside::previous, Beside::previous).size(), 2u);
  expect_same_stitches(finished(editable),
                       shaped_tube(8, {links(8), "||Y|||||", links(9), "||A|||||", links(8)}));
}

TEST(InsertWale, SharesTheIncreaseWithTheOtherNeighbour) {
  EditableGraph editable(plain_tube(8, 6));
  EXPECT_EQ(insert_wale(editable, 18, 2, Beside::next, Beside::next).size(), 2u);
  expect_same_stitches(finished(editable),
                       shaped_tube(8, {links(8), "|||Y||||", links(9), "|||A||||", links(8)}));
}

TEST(InsertWale, NeedsARowBelowAndARowAbove) {
  EditableGraph editable(plain_tube(8, 6));
  EXPECT_TRUE(insert_wale(editable, 2, 2, Beside::previous, Beside::previous).empty());
  EXPECT_TRUE(insert_wale(editable, 34, 2, Beside::previous, Beside::previous).empty());
}

TEST(InsertWale, LeavesShapedStitchesAlone) {
  EditableGraph editable(shaped_tube(8, {links(8), "||Y|||||", links(9), links(9), links(9)}));
  // Node 10 is increased into 18 and 19: no further loop, and no decrease, may come of it.
  EXPECT_TRUE(insert_wale(editable, 18, 1, Beside::previous, Beside::previous).empty());
  EXPECT_TRUE(insert_wale(editable, 9, 1, Beside::previous, Beside::next).empty());
  EXPECT_FALSE(insert_wale(editable, 22, 1, Beside::previous, Beside::previous).empty());

  // Node 18 joins two loops: it must not make two as well, but its neighbour 19 may.
  EditableGraph narrowing(shaped_tube(8, {links(8), "||A||||", links(7), links(7)}));
  EXPECT_TRUE(insert_wale(narrowing, 25, 1, Beside::previous, Beside::previous).empty());
  EXPECT_FALSE(insert_wale(narrowing, 25, 1, Beside::next, Beside::previous).empty());
}

TEST(InsertStitches, AnywhereAndAnyNumberCanBeKnit) {
  for (const KnitGraph& graph : drawn_graphs()) {
    EditableGraph editable(graph);
    Dice dice(graph.nodes.size());
    int rows = 0, wales = 0;
    for (int k = 0; k < 300; ++k) {
      const int node = dice.roll(editable.size());
      if (dice.roll(2) == 0) {
        rows += !insert_short_row(editable, node, 3 + dice.roll(6)).empty();
      } else {
        const Beside a = dice.roll(2) ? Beside::previous : Beside::next;
        const Beside b = dice.roll(2) ? Beside::previous : Beside::next;
        wales += !insert_wale(editable, node, 1 + dice.roll(4), a, b).empty();
      }
    }
    const KnitGraph edited = finished(editable);
    EXPECT_EQ(edited.rows.size(), graph.rows.size() + rows);
    for (const Problem& problem : check_knit_graph(edited).problems)
      EXPECT_NE(problem.severity, Severity::error) << problem.message;
    EXPECT_EQ(measure_graph(edited).splits, measure_graph(graph).splits);
    EXPECT_EQ(measure_graph(edited).merges, measure_graph(graph).merges);
    EXPECT_TRUE(check_trace(edited, trace_knit_graph(edited)).empty());
  }
}

}  // namespace
}  // namespace meshknit
