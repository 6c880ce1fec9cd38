// Tubes that part into three and more, or meet, in one row.

#include <gtest/gtest.h>

#include <algorithm>

#include "meshknit/knit_graph/closed_row_links.h"
#include "meshknit/knit_graph/knit_graph_checks.h"
#include "meshknit/remesh/remesh.h"
#include "meshknit/surface/blob_shape.h"
#include "shapes.h"

namespace meshknit {
namespace {

// A flat trunk (its time: `trunk_time`) below limbs that rise side by side along x, in an arc that
// puts each limb's foot this much lower than the one further in.
ExampleShape comb(int limbs, double trunk_time, double lower = 0.0) {
  constexpr double apart = 48.0, trunk = 60.0, height = 140.0, radius = 15.0;
  Blobs blobs;
  blobs.rounding = 5.0;
  const double middle = 0.5 * (limbs - 1);
  std::vector<TimedRim> rims;
  const Limb stem = {{{0.0, 0.0, trunk - 30.0}, 26.0}, {{0.0, 0.0, -20.0}, 26.0}};
  blobs.limbs.push_back(stem);
  rims.push_back({end_of(stem), trunk_time});
  blobs.ellipsoids.push_back({{0.0, 0.0, trunk - 25.0}, {apart * middle + 20.0, 22.0, 32.0}});
  for (int k = 0; k < limbs; ++k) {
    const double x = apart * (k - middle), low = lower * std::abs(k - middle);
    const Limb limb = {{{x, 0.0, trunk - 30.0 - low}, radius},
                       {{x, 0.0, height - low}, radius}};
    blobs.limbs.push_back(limb);
    rims.push_back({end_of(limb), -trunk_time});
  }
  return shape_of_blobs(blobs, rims, 5.0);
}

// How many tubes part or meet in one row at most.
struct Ways {
  int split = 0, merge = 0;
};

Ways most_ways(const KnitGraph& graph) {
  const ClosedRowLinks links = link_closed_rows(graph, RowWalk(graph));
  Ways most;
  for (const std::vector<int>& above : links.above)
    most.split = std::max(most.split, static_cast<int>(above.size()));
  for (std::size_t row = 0; row < graph.rows.size(); ++row)
    if (graph.rows[row].closed)
      most.merge = std::max(most.merge, static_cast<int>(links.below[row].size()));
  return most;
}

KnitGraph graph_of(const ExampleShape& shape, double times = 1.0) {
  const RemeshOptions options = gauge(times);
  const TimedShape ready = timed(shape, options.stitch_width);
  const KnitGraph graph = remesh(ready.surface, ready.time, options);
  for (const Problem& problem : check_knit_graph(graph).problems)
    EXPECT_NE(problem.severity, Severity::error) << problem.message;
  return graph;
}

TEST(KWayJunctions, LimbsOfOneHeightPartInOneRow) {
  for (const double times : {0.8, 1.0, 1.4}) {
    EXPECT_EQ(most_ways(graph_of(comb(3, -1.0), times)).split, 3) << times;
    EXPECT_EQ(most_ways(graph_of(comb(3, 1.0), times)).merge, 3) << times;
  }
  const KnitGraphStats stats = measure_graph(graph_of(comb(4, -1.0)));
  EXPECT_EQ(stats.splits, 3) << "a trunk becomes four limbs";
}

TEST(KWayJunctions, LimbsOfDifferentHeightPartOneAfterAnother) {
  const KnitGraph graph = graph_of(comb(4, -1.0, 20.0));
  EXPECT_EQ(measure_graph(graph).splits, 3);
  EXPECT_LT(most_ways(graph).split, 4);
}

}  // namespace
}  // namespace meshknit
