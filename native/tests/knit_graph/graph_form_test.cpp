#include <gtest/gtest.h>

#include <limits>

#include "graphs.h"
#include "meshknit/knit_graph/knit_graph_checks.h"

namespace meshknit {
namespace {

bool has(const KnitGraph& graph, const std::string& code) {
  return find_problem(check_graph_form(graph), code) != nullptr;
}

TEST(GraphForm, AHandDrawnTubeIsComplete) {
  EXPECT_TRUE(check_graph_form(plain_tube(6, 3)).empty());
}

TEST(GraphForm, EveryNodeIsInExactlyOneRow) {
  KnitGraph graph = plain_tube(6, 3);
  graph.rows[1].nodes[2] = graph.rows[1].nodes[3];
  const Problems problems = check_graph_form(graph);
  ASSERT_EQ(problems.size(), 2u) << "one node twice, one not at all";
  // Row 1 has nodes 6..11: its third is 8.
  EXPECT_EQ(problems[0].elements.nodes, std::vector<int>{8});
  EXPECT_EQ(problems[1].elements.nodes, std::vector<int>{9});
}

TEST(GraphForm, NobodyNamesANodeThatIsNotThere) {
  KnitGraph row = plain_tube(6, 3);
  row.rows[0].nodes[0] = 99;
  EXPECT_TRUE(has(row, "node-out-of-range"));
  KnitGraph column = plain_tube(6, 3);
  column.columns[0][1] = -1;
  EXPECT_TRUE(has(column, "column-out-of-range"));
}

TEST(GraphForm, TwoStitchesDoNotGoRoundATube) {
  EXPECT_TRUE(has(plain_tube(2, 2), "row-too-short"));
}

TEST(GraphForm, ColumnsComeInOrderAndOnce) {
  KnitGraph swapped = plain_tube(6, 3);
  std::swap(swapped.columns[0], swapped.columns[1]);
  EXPECT_TRUE(has(swapped, "columns-out-of-order"));
  KnitGraph increase = shaped_tube(6, {"Y|||||"});
  EXPECT_FALSE(has(increase, "columns-out-of-order"));
  std::swap(increase.columns[0], increase.columns[1]);
  EXPECT_TRUE(has(increase, "columns-out-of-order"))
      << "an increase's columns go along the row";
  KnitGraph twice = shaped_tube(6, {"Y|||||"});
  twice.columns[1] = twice.columns[0];
  EXPECT_TRUE(has(twice, "columns-out-of-order"));
}

TEST(GraphForm, LengthsArePresentAndPositive) {
  KnitGraph row = one_short_row();
  row.row_lengths[1].push_back(3.66);  // 4 nodes in an open row have 3 edges
  EXPECT_TRUE(has(row, "missing-length"));
  KnitGraph column = one_short_row();
  column.column_lengths.pop_back();
  EXPECT_TRUE(has(column, "missing-length"));
  KnitGraph zero = one_short_row();
  zero.column_lengths[3] = 0.0;
  EXPECT_TRUE(has(zero, "bad-length"));
  KnitGraph nan = one_short_row();
  nan.nodes[3].time = std::numeric_limits<double>::quiet_NaN();
  EXPECT_TRUE(has(nan, "bad-number"));
}

TEST(GraphForm, AnUnreadableGraphIsNotAskedForItsProperties) {
  KnitGraph graph = plain_tube(6, 3);
  graph.columns[0][1] = 1000;
  const KnitGraphCheck check = check_knit_graph(graph);
  EXPECT_TRUE(has_errors(check.problems));
  EXPECT_EQ(check.violations, (std::array<int, 6>{}));
}

}  // namespace
}  // namespace meshknit
