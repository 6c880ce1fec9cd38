// Every example, its openings cut, becomes a graph that can be knit and fits.

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <map>
#include <set>

#include "knit_graph/knit_graph_text.h"
#include "meshknit/knit_graph/knit_graph_checks.h"
#include "meshknit/remesh/remesh.h"
#include "problem_text.h"
#include "shapes.h"

namespace meshknit {
namespace {

// A shape and how often its tubes part and meet on the way from the first time to the last.
struct Branching {
  const char* name;
  int splits, merges;
};

// Two limbs on a trunk part once, three twice; the mitten's thumb leaves the hand once; the ring's
// two halves part at the bottom and meet at the top. Teddy's feet meet in the body; both arms
// leave it, and at the end its ears part.
const Branching branchings[] = {
    {"straight_tube", 0, 0}, {"cone", 0, 0},
    {"bent_tube", 0, 0},     {"sock", 0, 0},
    {"two_way_split", 1, 0}, {"three_way_split", 2, 0},
    {"two_way_merge", 0, 1}, {"three_way_merge", 0, 2},
    {"trousers", 1, 0},      {"mitten", 1, 0},
    {"ring_torus", 1, 1},    {"teddy", 3, 1},
};

class EveryExampleGraph : public testing::TestWithParam<Branching> {
 protected:
  TimedShape shape_for(const RemeshOptions& options) const {
    return timed(opened(example_shape(GetParam().name), options.stitch_width),
                 options.stitch_width);
  }
};
INSTANTIATE_TEST_SUITE_P(ExampleGraphs, EveryExampleGraph, testing::ValuesIn(branchings),
                         [](const auto& shape) { return std::string(shape.param.name); });

TEST(ExampleGraphs, AreThoseOfAllExamples) {
  std::vector<std::string> names;
  for (const Branching& shape : branchings) names.push_back(shape.name);
  EXPECT_EQ(names, example_shape_names());
}

TEST_P(EveryExampleGraph, CanBeKnitAtFiveGaugesAndFitsUnlessTheyAreCoarse) {
  for (const double times : {0.6, 0.8, 1.0, 1.4, 2.0}) {
    SCOPED_TRACE(times);
    const RemeshOptions options = gauge(times);
    const TimedShape shape = shape_for(options);
    const KnitGraph graph = remesh(shape.surface, shape.time, options);
    EXPECT_EQ(errors_of(check_knit_graph(graph).problems), "");
    const KnitGraphStats stats = measure_graph(graph);
    EXPECT_EQ(stats.splits, GetParam().splits);
    EXPECT_EQ(stats.merges, GetParam().merges);
    EXPECT_EQ(stats.splits + stats.merges,
              check_time_field(shape.surface, shape.time).expected_saddles);
    // A node covers l_r x 2 l_c of the surface.
    const double wanted =
        shape.surface.area / (options.stitch_width * 2.0 * options.stitch_height);
    EXPECT_NEAR(stats.nodes, wanted, (times < 1.4 ? 0.1 : 0.15) * wanted);
    // Of stitches twice as wide, an ear has a dozen: no arrangement of so few fits everywhere.
    if (times == 2.0) continue;
    EXPECT_GE(stats.row_error.within_10, 0.97);
    EXPECT_GE(stats.column_error.within_10, 0.95);
    if (times == 1.0) {
      EXPECT_GE(stats.column_error.within_20, 0.99);
    }
  }
}

TEST_P(EveryExampleGraph, GivesTheSameBytesTwice) {
  const TimedShape shape = shape_for({}), again = shape_for({});
  EXPECT_EQ(write_knit_graph(remesh(shape.surface, shape.time)),
            write_knit_graph(remesh(again.surface, again.time)));
}

TEST_P(EveryExampleGraph, HardlyDependsOnHowTheMeshIsNumbered) {
  const ExampleShape drawn = opened(example_shape(GetParam().name));
  const TimedShape shape = timed(drawn), renumbered = timed(shuffled(drawn, 5));
  const double nodes = static_cast<double>(remesh(shape.surface, shape.time).nodes.size());
  EXPECT_NEAR(static_cast<double>(remesh(renumbered.surface, renumbered.time).nodes.size()),
              nodes, 0.01 * nodes);
}

TEST_P(EveryExampleGraph, CanBeKnitAsItWasPeeled) {
  const TimedShape shape = shape_for({});
  RemeshOptions as_peeled;
  as_peeled.relax = false;
  const KnitGraph even = remesh(shape.surface, shape.time);
  const KnitGraph peeled = remesh(shape.surface, shape.time, as_peeled);
  EXPECT_EQ(errors_of(check_knit_graph(peeled).problems), "");
  EXPECT_LE(measure_graph(even).column_error.mean,
            measure_graph(peeled).column_error.mean + 1e-9);
  // Evening out adds stitches, and few.
  EXPECT_GE(even.nodes.size(), peeled.nodes.size());
  EXPECT_LE(static_cast<double>(even.nodes.size()),
            1.03 * static_cast<double>(peeled.nodes.size()));
}

// Closed rows that columns join directly, from below (`side` 0) or from above (1).
std::vector<std::set<int>> joined_closed_rows(const KnitGraph& graph,
                                              const std::vector<int>& row_of, int side) {
  std::vector<std::set<int>> joined(graph.rows.size());
  for (const auto& column : graph.columns) {
    const int row = row_of[column[side]], other = row_of[column[1 - side]];
    if (graph.rows[row].closed && graph.rows[other].closed) joined[row].insert(other);
  }
  return joined;
}

TEST_P(EveryExampleGraph, LinksRowsOneToOneWhereTubesPartAndMeet) {
  const TimedShape shape = shape_for({});
  const KnitGraph graph = remesh(shape.surface, shape.time);
  std::vector<int> row_of(graph.nodes.size(), -1);
  for (std::size_t row = 0; row < graph.rows.size(); ++row)
    for (const int node : graph.rows[row].nodes) row_of[node] = static_cast<int>(row);
  const int expected[] = {GetParam().splits, GetParam().merges};
  for (const int side : {0, 1}) {
    const auto joined = joined_closed_rows(graph, row_of, side);
    int junctions = 0;
    for (std::size_t row = 0; row < joined.size(); ++row) {
      if (joined[row].size() < 2) continue;
      junctions += static_cast<int>(joined[row].size()) - 1;
      std::map<int, int> columns_of;  // of this row's nodes and of their partners
      for (const auto& column : graph.columns)
        if (row_of[column[side]] == static_cast<int>(row)) {
          ++columns_of[column[0]];
          ++columns_of[column[1]];
        }
      std::size_t stitches = graph.rows[row].nodes.size();
      for (const int other : joined[row]) stitches += graph.rows[other].nodes.size();
      EXPECT_EQ(columns_of.size(), stitches) << "no stitch is left out";
      for (const auto& [node, columns] : columns_of) EXPECT_EQ(columns, 1) << "node " << node;
    }
    EXPECT_EQ(junctions, expected[side]);
  }
}

}  // namespace
}  // namespace meshknit
