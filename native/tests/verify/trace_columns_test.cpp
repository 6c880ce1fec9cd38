#include "meshknit/verify/trace_columns.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <set>

#include "graphs.h"
#include "meshknit/core/error.h"
#include "meshknit/knit_graph/closed_row_links.h"
#include "meshknit/pipeline/pipeline.h"
#include "meshknit/tracing/trace.h"
#include "random_surfaces.h"
#include "verify/worked_example.h"

namespace meshknit {
namespace {

std::size_t junctions(const KnitGraph& graph) {
  return find_trace_columns(trace_knit_graph(graph)).junctions.size();
}

TEST(TraceColumns, ATubeNeverPartsWhateverItsShape) {
  for (std::uint64_t seed = 0; seed < 300; ++seed) {
    SCOPED_TRACE(seed);
    EXPECT_EQ(junctions(random_tube(seed)), 0u);
  }
  EXPECT_TRUE(find_trace_columns(worked_trace()).junctions.empty());
}

TEST(TraceColumns, EveryFurtherTubePartsOnceAndMeetsOnce) {
  EXPECT_EQ(junctions(splitting_tube(4)), 1u);
  EXPECT_EQ(junctions(merging_tube(4)), 1u);
  EXPECT_EQ(junctions(three_way_split(6, 4, 6, 4)), 2u);
  EXPECT_EQ(find_trace_columns(branches_trace()).junctions.size(), 2u);
}

// Whatever the shaping and wherever short rows end. A row under k closed rows parts k - 1 times,
// one over k of them meets k - 1 times.
TEST(TraceColumns, RandomSurfacesPartAndMeetAsOftenAsTheirGraphs) {
  std::size_t most = 0;
  int knitted = 0;
  for (std::uint32_t seed = 0; seed < 12; ++seed) {
    SCOPED_TRACE(seed);
    const RandomSurface random = random_surface(seed);
    KnitGraph graph;
    try {
      graph = build_knit_graph(random.timed.surface, random.timed.time, random.gauge).graph;
    } catch (const NotKnittable&) {
      continue;  // too thin somewhere at this gauge: remeshing's business
    }
    ++knitted;
    const ClosedRowLinks links = link_closed_rows(graph, RowWalk(graph));
    std::size_t expected = 0;
    for (std::size_t row = 0; row < graph.rows.size(); ++row) {
      if (!graph.rows[row].closed) continue;
      if (links.is_split(static_cast<int>(row))) expected += links.above[row].size() - 1;
      if (links.is_merge(static_cast<int>(row))) expected += links.below[row].size() - 1;
    }
    EXPECT_EQ(junctions(graph), expected);
    most = std::max(most, expected);
  }
  EXPECT_GE(knitted, 8);
  EXPECT_GE(most, 4u);
}

TEST(TraceColumns, TheHandExamplePartsAndMeetsWhereItIsDrawn) {
  const TraceColumns found = find_trace_columns(branches_trace());
  // Starts 0 to 7 begin the columns f16 f14 f12 f10 b11 b13 b15 b17. Stitch 14 comes from b13 (5)
  // to f12 (2): these close the left tube. The round went from b17 to f16 before stitch 8, and from
  // f14 to f12 before 10 and from b13 to b15 before 6; the last of the latter two opens.
  const Junction& parts = found.junctions.at(0);
  EXPECT_EQ(parts.stitch, 14);
  EXPECT_EQ(parts.first, 2);
  EXPECT_EQ(parts.second, 5);
  EXPECT_EQ(parts.opens, 10);
  // Stitch 42 comes from f14 (1) to f12 (2). Stitch 38 was the last from f14 to b15; no stitch of
  // the left tube comes from b13 to f12 after 28.
  const Junction& meets = found.junctions.at(1);
  EXPECT_EQ(meets.stitch, 42);
  EXPECT_EQ(meets.first, 2);
  EXPECT_EQ(meets.second, 1);
  EXPECT_EQ(meets.opens, 38);
}

TEST(TraceColumns, EveryStitchStandsInTheColumnOfItsParents) {
  for (std::uint64_t seed = 0; seed < 20; ++seed) {
    const StitchTrace trace = trace_knit_graph(random_tube(seed));
    const TraceColumns found = find_trace_columns(trace);
    std::set<int> columns;
    std::size_t begun = 0;
    for (std::size_t s = 0; s < trace.stitches.size(); ++s) {
      const StitchKind kind = trace.stitches[s].kind;
      begun += kind == StitchKind::start || kind == StitchKind::increase;
      columns.insert(found.of[s][0]);
      if (kind == StitchKind::increase) columns.insert(found.of[s][1]);
      EXPECT_GE(found.of[s][0], 0);
    }
    EXPECT_EQ(columns.size(), begun);
    EXPECT_EQ(found.columns, static_cast<int>(begun));
  }
}

}  // namespace
}  // namespace meshknit
