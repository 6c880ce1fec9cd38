#include "graphs.h"

#include <gtest/gtest.h>

#include "knit_graph/knit_graph_text.h"
#include "meshknit/knit_graph/knit_graph_checks.h"
#include "meshknit/knit_graph/rows.h"

namespace meshknit {
namespace {

void expect_clean(const KnitGraph& graph) {
  const Problems problems = check_knit_graph(graph).problems;
  EXPECT_TRUE(problems.empty()) << problems.front().code << ": " << problems.front().message;
}

TEST(Graphs, HandDrawnGraphsKeepEveryProperty) {
  for (const int n : {3, 5, 8, 31})
    for (const int rows : {1, 2, 5}) expect_clean(plain_tube(n, rows));
  expect_clean(shaped_tube(6, {"Y||Y||", "A||A||", "|A|Y|"}));
  expect_clean(one_short_row());
  expect_clean(short_row_over_seam());
  expect_clean(nested_short_rows());
  expect_clean(short_row_with_increase());
  for (const int k : {2, 3, 5}) expect_clean(stacked_short_rows(k));
}

TEST(Graphs, RandomTubesKeepEveryPropertyAndHaveAllShaping) {
  int increases = 0, decreases = 0, short_rows = 0;
  for (int seed = 0; seed < 300; ++seed) {
    const KnitGraph graph = random_tube(seed);
    expect_clean(graph);
    const RowWalk walk(graph);
    for (int node = 0; node < static_cast<int>(graph.nodes.size()); ++node) {
      increases += walk.above(node).size() == 2;
      decreases += walk.below(node).size() == 2;
    }
    short_rows += measure_graph(graph).short_rows;
  }
  // Enough of each to trust what is tested on them: a few a graph.
  EXPECT_GT(increases, 900);
  EXPECT_GT(decreases, 900);
  EXPECT_GT(short_rows, 900);
}

TEST(Graphs, ASeedAlwaysGivesTheSameTube) {
  EXPECT_EQ(write_knit_graph(random_tube(7)), write_knit_graph(random_tube(7)));
  EXPECT_NE(write_knit_graph(random_tube(7)), write_knit_graph(random_tube(8)));
}

}  // namespace
}  // namespace meshknit
