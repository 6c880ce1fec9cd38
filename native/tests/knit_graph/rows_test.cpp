#include "meshknit/knit_graph/rows.h"

#include <gtest/gtest.h>

#include <algorithm>

#include "graphs.h"

namespace meshknit {
namespace {

TEST(Rows, AClosedRowGoesRoundAndAShortRowEnds) {
  const KnitGraph graph = one_short_row();
  const RowWalk walk(graph);
  const std::vector<int>&round = graph.rows[0].nodes, &part = graph.rows[1].nodes;
  EXPECT_EQ(walk.next(round.back()), round.front());
  EXPECT_EQ(walk.previous(round.front()), round.back());
  EXPECT_EQ(walk.next(part.back()), -1);
  EXPECT_EQ(walk.previous(part.front()), -1);
  EXPECT_TRUE(walk.is_row_end(part.front()));
  EXPECT_FALSE(walk.is_row_end(part[1]));
  EXPECT_FALSE(walk.is_row_end(round.front()));
}

TEST(Rows, ColumnsAcrossTheBeginningOfARowKeepYarnOrder) {
  // The increase over node 0 makes the upper row's first two nodes; listed from the second of
  // them on, that row's list begins in the middle of the increase.
  KnitGraph graph = shaped_tube(4, {"Y|||"});
  std::vector<int>& upper = graph.rows[1].nodes;
  const int left = upper[0], right = upper[1];
  std::rotate(upper.begin(), upper.begin() + 1, upper.end());
  const RowWalk walk(graph);
  EXPECT_EQ(walk.above(0), (std::vector<int>{left, right}));
  EXPECT_EQ(upper.back(), left) << "the pair is the row's last node and its first";
}

TEST(Rows, ADecreaseStandsOnTwoNodesInYarnOrder) {
  const KnitGraph graph = shaped_tube(5, {"|A||"});
  const RowWalk walk(graph);
  EXPECT_EQ(walk.below(graph.rows[1].nodes[1]), (std::vector<int>{1, 2}));
  EXPECT_EQ(walk.place(graph.rows[1].nodes[1]).row, 1);
  EXPECT_EQ(walk.place(graph.rows[1].nodes[1]).index, 1);
}

}  // namespace
}  // namespace meshknit
