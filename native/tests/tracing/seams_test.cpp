#include "meshknit/tracing/seams.h"

#include <gtest/gtest.h>

#include <algorithm>

#include "branching_graphs.h"
#include "graphs.h"
#include "meshknit/knit_graph/knit_graph_checks.h"
#include "meshknit/tracing/trace.h"
#include "meshknit/tracing/trace_checks.h"
#include "meshknit/tracing/tubes.h"

namespace meshknit {
namespace {

TEST(Seams, NoneIsNeededWhereTheTubesCanHang) {
  for (const KnitGraph& graph : {plain_tube(8, 4), three_legs(6, 6, 6, 4),
                                 tube_with_hole(6, 6, 4), crossed_pairs(4, 5, false)}) {
    const SeamPlan plan = plan_seams(graph);
    EXPECT_FALSE(plan.needed);
    EXPECT_TRUE(plan.seams.empty());
  }
}

TEST(Seams, PairsThatMeetCrosswiseNeedOneRoundAQuarterOfTheTrunk) {
  for (const int n : {4, 5, 9}) {
    const KnitGraph graph = crossed_pairs(n, 3, true);
    const SeamPlan plan = plan_seams(graph);
    ASSERT_TRUE(plan.needed);
    ASSERT_EQ(plan.seams.size(), 1u);
    // The narrowest tubes have n nodes a row; that all columns are cut shows that nothing else
    // hangs between.
    const Seam& seam = plan.seams.front();
    EXPECT_EQ(graph.rows[seam.row_below].nodes.size(), static_cast<std::size_t>(n));
    EXPECT_EQ(seam.columns.size(), static_cast<std::size_t>(n));

    const KnitGraph cut = cut_along(graph, plan.seams);
    EXPECT_EQ(cut.columns.size() + seam.columns.size(), graph.columns.size());
    EXPECT_TRUE(check_knit_graph(cut).problems.empty());
    EXPECT_FALSE(plan_seams(cut).needed);
    EXPECT_EQ(find_tubes(cut).count, find_tubes(graph).count + 1);

    const StitchTrace trace = trace_knit_graph(cut);
    EXPECT_TRUE(check_trace(cut, trace).empty());
    const auto count = [&](StitchKind kind) {
      return std::count_if(trace.stitches.begin(), trace.stitches.end(),
                           [&](const Stitch& s) { return s.kind == kind; });
    };
    // The trunk's 4 n and those of the seam.
    EXPECT_EQ(count(StitchKind::start), 5 * n);
    EXPECT_EQ(count(StitchKind::end), 5 * n);
  }
}

// A knot of four quarters, each of which first widens or narrows: `growth` nodes a row.
KnitGraph crossing_of(const std::vector<std::vector<std::string>>& rows, bool short_row) {
  GraphDrawing drawing;
  GraphDrawing::Front front = drawing.cast_on(24);
  front = drawing.closed_row(front, links(24));
  std::vector<GraphDrawing::Front> quarters;
  for (const int half : {0, 12}) {
    GraphDrawing::Front part(front.begin() + half, front.begin() + half + 12);
    part = drawing.closed_row(part, links(12));
    for (const int quarter : {0, 6}) {
      GraphDrawing::Front own(part.begin() + quarter, part.begin() + quarter + 6);
      own = drawing.closed_row(own, links(6));
      for (const std::string& row : rows[quarters.size()]) own = drawing.closed_row(own, row);
      if (short_row) own = drawing.short_row(own, 1, links(4));
      quarters.push_back(drawing.closed_row(own, links(static_cast<int>(own.size()))));
    }
  }
  std::vector<GraphDrawing::Front> pairs;
  for (const int k : {0, 1}) {
    GraphDrawing::Front both = quarters[k];
    both.insert(both.end(), quarters[k + 2].begin(), quarters[k + 2].end());
    pairs.push_back(drawing.closed_row(both, links(static_cast<int>(both.size()))));
  }
  GraphDrawing::Front all = pairs[0];
  all.insert(all.end(), pairs[1].begin(), pairs[1].end());
  drawing.closed_row(all, links(static_cast<int>(all.size())));
  return drawing.graph();
}

TEST(Seams, LieWhereTheTubeIsNarrowest) {
  // Only the third quarter narrows: 6, 5, 4, 4, 5, 6 nodes, and 6 where it meets.
  const std::vector<std::string> plain(5, links(6));
  const std::vector<std::string> waist{"A||||", "A|||", "||||", "Y|||", "Y||||"};
  const KnitGraph graph = crossing_of({plain, plain, waist, plain}, false);
  ASSERT_TRUE(check_knit_graph(graph).problems.empty());
  const SeamPlan plan = plan_seams(graph);
  ASSERT_EQ(plan.seams.size(), 1u);
  EXPECT_EQ(graph.rows[plan.seams[0].row_below].nodes.size(), 4u);
  EXPECT_EQ(graph.rows[plan.seams[0].row_above].nodes.size(), 4u);
  // Between the nodes that are sewn to each other.
  Eigen::Vector3d sum = Eigen::Vector3d::Zero();
  for (const auto& [from, to] : plan.seams[0].columns)
    sum += graph.nodes[from].position + graph.nodes[to].position;
  EXPECT_LT((sum / 8.0 - plan.seams[0].middle).norm(), 1e-9);
}

TEST(Seams, KeepAwayFromShortRows) {
  // Every quarter has four rows, the last upon a short row: two gaps of three are left.
  const std::vector<std::string> plain(2, links(6));
  const KnitGraph graph = crossing_of({plain, plain, plain, plain}, true);
  ASSERT_TRUE(check_knit_graph(graph).problems.empty());
  const SeamPlan plan = plan_seams(graph);
  ASSERT_EQ(plan.seams.size(), 1u);
  const KnitGraph cut = cut_along(graph, plan.seams);
  EXPECT_TRUE(check_knit_graph(cut).problems.empty());
  EXPECT_TRUE(check_trace(cut, trace_knit_graph(cut)).empty());
}

}  // namespace
}  // namespace meshknit
