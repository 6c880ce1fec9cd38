#include "meshknit/remesh/remesh.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <numeric>
#include <optional>

#include "knit_graph/knit_graph_text.h"
#include "meshknit/core/error.h"
#include "meshknit/knit_graph/knit_graph_checks.h"
#include "problem_text.h"
#include "shapes.h"
#include "surface/test_meshes.h"

namespace meshknit {
namespace {

KnitGraph remesh(const TimedShape& shape) { return remesh(shape.surface, shape.time); }

int short_rows(const KnitGraph& graph) {
  return static_cast<int>(std::count_if(graph.rows.begin(), graph.rows.end(),
                                        [](const KnitRow& row) { return !row.closed; }));
}

struct Shaping {
  int increases = 0, decreases = 0;
};
Shaping shaping(const KnitGraph& graph) {
  std::vector<int> up(graph.nodes.size(), 0), down(graph.nodes.size(), 0);
  for (const auto& column : graph.columns) {
    ++up[column[0]];
    ++down[column[1]];
  }
  const auto twos = [](const std::vector<int>& degree) {
    return static_cast<int>(std::count(degree.begin(), degree.end(), 2));
  };
  return {twos(up), twos(down)};
}

class EveryShape : public testing::TestWithParam<std::string> {};
INSTANTIATE_TEST_SUITE_P(Remesh, EveryShape, testing::ValuesIn(shape_names()),
                         [](const auto& shape) { return shape.param; });

TEST_P(EveryShape, GivesAGraphThatCanBeKnitAndFitsAtThreeSizes) {
  for (const double size : shape_sizes) {
    SCOPED_TRACE(size);
    const TimedShape shape = shape_named(GetParam(), size);
    const KnitGraph graph = remesh(shape);
    EXPECT_EQ(errors_of(check_knit_graph(graph).problems), "");
    const KnitGraphStats stats = measure_graph(graph);
    // A node covers l_r x 2 l_c of the surface, less where columns lean beside shaping.
    const double wanted = shape.surface.area / (3.66 * 3.46);
    EXPECT_NEAR(stats.nodes, wanted, 0.15 * wanted);
    EXPECT_GE(stats.row_error.within_10, 0.93);
    EXPECT_GE(stats.column_error.within_20, 0.95);
  }
}

TEST_P(EveryShape, GivesTheSameBytesTwice) {
  const TimedShape shape = shape_named(GetParam());
  EXPECT_EQ(write_knit_graph(remesh(shape)), write_knit_graph(remesh(shape)));
}

TEST_P(EveryShape, LiesOnItsSurface) {
  // Upright or bent, the shapes' faces are small: a node is nearer to some vertex than the
  // longest edge, and all nodes lie within the shape's bounding box.
  const ExampleShape arrays = arrays_of_shape(GetParam());
  const KnitGraph graph = remesh(timed(arrays));
  const Eigen::Vector3d low = arrays.vertices.colwise().minCoeff().transpose();
  const Eigen::Vector3d high = arrays.vertices.colwise().maxCoeff().transpose();
  for (const KnitNode& node : graph.nodes) {
    EXPECT_TRUE((node.position.array() >= low.array() - 1e-9).all());
    EXPECT_TRUE((node.position.array() <= high.array() + 1e-9).all());
    EXPECT_LE(
        (arrays.vertices.rowwise() - node.position.transpose()).rowwise().norm().minCoeff(),
        8.0);
  }
}

TEST_P(EveryShape, BeginsAndEndsOnItsRimsWithAWholeRow) {
  const TimedShape shape = shape_named(GetParam());
  const KnitGraph graph = remesh(shape);
  EXPECT_TRUE(graph.rows.front().closed);
  EXPECT_TRUE(graph.rows.back().closed);
  for (const int node : graph.rows.front().nodes)
    EXPECT_NEAR(graph.nodes[node].time, -1.0, 1e-3);
  for (const int node : graph.rows.back().nodes) EXPECT_NEAR(graph.nodes[node].time, 1.0, 1e-3);
}

TEST_P(EveryShape, HardlyDependsOnHowTheMeshIsNumbered) {
  const ExampleShape arrays = arrays_of_shape(GetParam());
  const double nodes = static_cast<double>(remesh(timed(arrays)).nodes.size());
  const double again = static_cast<double>(remesh(timed(shuffled(arrays, 5))).nodes.size());
  EXPECT_NEAR(again, nodes, std::max(0.01 * nodes, 3.0));
}

TEST(Remesh, FitsStitchesOverAllShapes) {
  std::size_t rows = 0, columns = 0;
  double rows_within = 0.0, columns_within = 0.0;
  for (const std::string& name : shape_names())
    for (const double size : shape_sizes) {
      const KnitGraphStats stats = measure_graph(remesh(shape_named(name, size)));
      rows += stats.row_error.edges;
      columns += stats.column_error.edges;
      rows_within += stats.row_error.edges * stats.row_error.within_10;
      columns_within += stats.column_error.edges * stats.column_error.within_10;
    }
  EXPECT_GE(rows_within, 0.93 * static_cast<double>(rows));
  EXPECT_GE(columns_within, 0.85 * static_cast<double>(columns));
}

TEST(Remesh, AStraightTubeHasNoShapingAndNoShortRows) {
  const KnitGraph graph = remesh(shape_named("straight_tube"));
  EXPECT_EQ(short_rows(graph), 0);
  // The cross-section has 40 corners on a circle of 30 mm: 188.3 mm, 51.4 stitches, so each row
  // has 51. The length of 120 mm is 34.7 rows of 3.46 mm: 35 after the first.
  for (const KnitRow& row : graph.rows) EXPECT_EQ(row.nodes.size(), 51u);
  EXPECT_EQ(graph.rows.size(), 36u);
  EXPECT_EQ(shaping(graph).increases, 0);
  EXPECT_EQ(shaping(graph).decreases, 0);
}

TEST(Remesh, AConeIsShapedOneWayOnly) {
  // The circumference falls from 45 to 20 mm radius: by 2 pi 25 / 3.66 = 43 stitches.
  const Shaping narrowing = shaping(remesh(shape_named("cone")));
  EXPECT_EQ(narrowing.increases, 0);
  EXPECT_NEAR(narrowing.decreases, 43, 1);
  const Shaping widening = shaping(remesh(shape_named("widening_cone")));
  EXPECT_EQ(widening.decreases, 0);
  EXPECT_NEAR(widening.increases, 43, 1);
}

TEST(Remesh, ABendGetsShortRowsOnTheOutsideOnly) {
  // The first leg runs down from the origin for 50 mm; then the centre line turns towards +x on
  // a circle of radius 50 about (50, -50) in the xz plane. The tube's own radius is 25: its
  // outer quarter lies more than 12.5 mm outside that circle, its inner quarter as far inside.
  for (const char* name : {"bent_tube_30", "bent_tube_60", "bent_tube", "bent_tube_120"}) {
    SCOPED_TRACE(name);
    const KnitGraph graph = remesh(shape_named(name));
    int outside = 0, inside = 0;
    for (const KnitRow& row : graph.rows) {
      if (row.closed) continue;
      const Eigen::Vector3d& middle = graph.nodes[row.nodes[row.nodes.size() / 2]].position;
      const double outward = std::hypot(middle.x() - 50.0, middle.z() + 50.0) - 50.0;
      outside += outward > 12.5;
      inside += outward < -12.5;
    }
    EXPECT_GE(outside, 3);
    EXPECT_EQ(inside, 0);
  }
}

TEST(Remesh, ASharperBendGetsMoreShortRows) {
  // The outside is longer than the inside by 2 r times the angle: 26, 52, 79 and 105 mm, or
  // 7.6, 15, 23 and 30 rows at the outermost place. Short rows that begin side by side make it
  // some more.
  const double extra_rows[] = {7.6, 15.1, 22.7, 30.3};
  const char* names[] = {"bent_tube_30", "bent_tube_60", "bent_tube", "bent_tube_120"};
  for (int k = 0; k < 4; ++k) {
    SCOPED_TRACE(names[k]);
    const int count = short_rows(remesh(shape_named(names[k])));
    EXPECT_GE(count, 0.6 * extra_rows[k]);
    EXPECT_LE(count, 1.6 * extra_rows[k]);
  }
}

TEST(Remesh, ASlantedRimIsReachedByShortRows) {
  // The rim rises by 2 r tan 30 degrees = 34.6 mm from its low to its high side: 10 rows.
  const KnitGraph graph = remesh(shape_named("tilted_cut"));
  EXPECT_GE(short_rows(graph), 5);
  double weighted = 0.0, nodes = 0.0;
  for (const KnitRow& row : graph.rows)
    for (const int node : row.nodes) {
      if (row.closed) continue;
      weighted += graph.nodes[node].position.x();
      ++nodes;
    }
  EXPECT_GT(weighted / nodes, 10.0) << "short rows lie on the high side";
}

TEST(Remesh, NoShortRowIsShorterThanTwoStitchWidths) {
  for (const std::string& name : shape_names())
    for (const KnitRow& row : remesh(shape_named(name)).rows)
      EXPECT_GE(row.nodes.size(), 3u) << name;
}

TEST(Remesh, FinerYarnGivesMoreStitches) {
  const TimedShape shape = shape_named("straight_tube");
  RemeshOptions fine;
  fine.stitch_width = 1.83;
  fine.stitch_height = 0.865;
  const double coarse = static_cast<double>(remesh(shape).nodes.size());
  EXPECT_NEAR(static_cast<double>(remesh(shape.surface, shape.time, fine).nodes.size()),
              4.0 * coarse, 0.1 * coarse);
}

TEST(Remesh, ProgressRisesToOne) {
  RunContext run;
  const TimedShape shape = shape_named("sock", 0.5);
  remesh(shape.surface, shape.time, {}, &run);
  EXPECT_DOUBLE_EQ(run.progress(), 1.0);
}

TEST(Remesh, StopsWhenCancelled) {
  RunContext run;
  run.cancel();
  const TimedShape shape = shape_named("sock");
  EXPECT_THROW(remesh(shape.surface, shape.time, {}, &run), Cancelled);
  EXPECT_EQ(run.progress(), 0.0) << "before any work was done";
}

TEST(Remesh, RefusesArgumentsThatMakeNoSense) {
  const TimedShape shape = shape_named("straight_tube", 0.5);
  EXPECT_THROW(remesh(shape.surface, {0.0, 1.0}), InvalidInput);
  EXPECT_THROW(remesh(shape.surface, shape.time, {0.0, 1.73}), InvalidInput);
  EXPECT_THROW(remesh(shape.surface, shape.time, {3.66, -1.0}), InvalidInput);
  EXPECT_THROW(remesh(shape.surface, shape.time, {3.66, std::nan("")}), InvalidInput);
}

TEST(Remesh, ShowsItsFirstRowsToWhoAsksForThem) {
  const TimedShape shape = shape_named("straight_tube");
  FirstRows rows;
  EXPECT_FALSE(rows.take().has_value()) << "nothing is knit yet; but now rows are asked for";
  const KnitGraph graph = remesh(shape.surface, shape.time, {}, nullptr, nullptr, &rows);
  const std::optional<KnitGraph> first = rows.take();
  ASSERT_TRUE(first.has_value());
  EXPECT_GT(first->nodes.size(), 0u);
  EXPECT_LT(first->nodes.size(), graph.nodes.size());
  for (const auto& column : first->columns)
    for (const int node : column) EXPECT_LT(node, static_cast<int>(first->nodes.size()));
}

}  // namespace
}  // namespace meshknit
