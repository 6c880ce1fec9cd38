#include <gtest/gtest.h>

#include <array>

#include "graphs.h"
#include "meshknit/knit_graph/knit_graph_checks.h"

namespace meshknit {
namespace {

TEST(GraphMeasures, CountsRowsAndShortRows) {
  const KnitGraphStats stats = measure_graph(nested_short_rows());
  // 12 nodes, short rows of 8, 6 and 4, then two rows of 12.
  EXPECT_EQ(stats.nodes, 12 + 8 + 6 + 4 + 12 + 12);
  EXPECT_EQ(stats.rows, 6);
  EXPECT_EQ(stats.short_rows, 3);
  EXPECT_EQ(stats.splits, 0);
  EXPECT_EQ(stats.merges, 0);
}

TEST(GraphMeasures, PerfectEdgesHaveNoError) {
  const KnitGraphStats stats = measure_graph(plain_tube(5, 4));
  EXPECT_EQ(stats.row_error.edges, 20);
  EXPECT_EQ(stats.column_error.edges, 15);
  EXPECT_NEAR(stats.row_error.mean, 0.0, 1e-12);
  EXPECT_NEAR(stats.column_error.p95, 0.0, 1e-12);
  EXPECT_DOUBLE_EQ(stats.column_error.within_10, 1.0);
}

TEST(GraphMeasures, TheHistogramTellsTooShortFromTooLong) {
  KnitGraph graph = plain_tube(5, 5);  // 20 columns of 2 l_c
  const double wanted = 2.0 * graph.stitch_height;
  graph.column_lengths[0] = 0.93 * wanted;
  graph.column_lengths[1] = 1.07 * wanted;
  graph.column_lengths[2] = 0.1 * wanted;
  graph.column_lengths[3] = 9.0 * wanted;
  const LengthError error = measure_graph(graph).column_error;
  // Bin 0 ends at -50 %, bin 1 + k begins k times 5 % above that.
  std::array<int, histogram_bins> expected{};
  expected[0] = 1;        // 90 % too short
  expected[1 + 8] = 1;    // -10 to -5 %
  expected[1 + 10] = 16;  // 0 to 5 %: the perfect ones
  expected[1 + 11] = 1;   // 5 to 10 %
  expected[1 + 20] = 1;   // 800 % too long
  EXPECT_EQ(error.histogram, expected);
  EXPECT_EQ(histogram_bound(0), -0.5);
  EXPECT_EQ(histogram_bound(10), 0.0);
  EXPECT_EQ(histogram_bound(histogram_bins - 2), 0.5);
}

TEST(GraphMeasures, CountsStitchesThatAreNotPlain) {
  const KnitGraphStats plain = measure_graph(plain_tube(5, 4));
  EXPECT_EQ(plain.irregular, 0);
  const KnitGraphStats nested = measure_graph(nested_short_rows());
  // Three short rows; their ends stand above each other.
  EXPECT_EQ(nested.short_row_ends, 6);
  EXPECT_GE(nested.irregular, 6);
  EXPECT_LE(nested.irregular, 6 + nested.increases + nested.decreases);
  // Columns up minus columns down: 12 nodes in the first row and 12 in the last.
  EXPECT_EQ(nested.increases, nested.decreases);
}

TEST(GraphMeasures, ErrorsAreRelativeAndCountTooShortAsTooLong) {
  KnitGraph graph = plain_tube(5, 5);  // 20 columns of 2 l_c
  const double wanted = 2.0 * graph.stitch_height;
  graph.column_lengths[0] = 1.5 * wanted;
  graph.column_lengths[1] = 0.85 * wanted;
  const LengthError error = measure_graph(graph).column_error;
  EXPECT_NEAR(error.mean, (0.5 + 0.15) / 20, 1e-12);
  // 19 of 20 edges, 95 %, are off by no more than 15 %.
  EXPECT_NEAR(error.p95, 0.15, 1e-12);
  EXPECT_DOUBLE_EQ(error.within_10, 18.0 / 20);
  EXPECT_DOUBLE_EQ(error.within_20, 19.0 / 20);
}

}  // namespace
}  // namespace meshknit
