#include <gtest/gtest.h>

#include "graphs.h"
#include "meshknit/tracing/trace.h"
#include "meshknit/tracing/trace_checks.h"

namespace meshknit {
namespace {

StitchTrace trace_cleanly(const KnitGraph& graph) {
  const StitchTrace trace = trace_knit_graph(graph);
  const Problems problems = check_trace(graph, trace);
  EXPECT_TRUE(problems.empty()) << problems.front().code << ": " << problems.front().message;
  EXPECT_EQ(trace.stitches.size(), 2 * graph.nodes.size());
  return trace;
}

TEST(TraceSplits, ATwoWaySplitNeedsOneMoreYarn) {
  for (const int n : {3, 4, 9}) EXPECT_EQ(trace_cleanly(splitting_tube(n)).yarns, 2);
}

TEST(TraceSplits, EveryCastOnNeedsAYarnAndAMergeNoFurther) {
  for (const int n : {3, 4, 9}) EXPECT_EQ(trace_cleanly(merging_tube(n)).yarns, 2);
}

TEST(TraceSplits, AThreeWaySplitNeedsTwoMoreYarns) {
  EXPECT_EQ(trace_cleanly(three_way_split(6, 4, 6, 4)).yarns, 3);
}

TEST(TraceSplits, TheYarnThatArrivesLastGoesOnAfterAMerge) {
  const KnitGraph graph = merging_tube(4);
  const StitchTrace trace = trace_cleanly(graph);
  EXPECT_EQ(trace.stitches.back().yarn, 1);
}

TEST(TraceSplits, AnArmWithShortRowsKeepsItsYarn) {
  GraphDrawing drawing;
  auto trunk = drawing.cast_on(12);
  trunk = drawing.short_row(trunk, 2, "||||");
  trunk = drawing.closed_row(trunk, links(12));
  auto left = drawing.closed_row({trunk.begin(), trunk.begin() + 6}, "||||||");
  auto right = drawing.closed_row({trunk.begin() + 6, trunk.end()}, "||||||");
  right = drawing.short_row(right, 4, "||||");
  drawing.closed_row(right, "||||||");
  drawing.closed_row(left, "||||||");
  const KnitGraph graph = drawing.graph();
  const StitchTrace trace = trace_knit_graph(graph);
  const Problems problems = check_trace(graph, trace);
  EXPECT_TRUE(problems.empty()) << problems.front().message;
  EXPECT_EQ(trace.yarns, 2);
}

TEST(TraceSplits, AHandleSplitsAndMerges) {
  GraphDrawing drawing;
  auto trunk = drawing.cast_on(10);
  trunk = drawing.closed_row(trunk, links(10));
  auto left = drawing.closed_row({trunk.begin(), trunk.begin() + 5}, links(5));
  auto right = drawing.closed_row({trunk.begin() + 5, trunk.end()}, links(5));
  left = drawing.closed_row(left, links(5));
  right = drawing.closed_row(right, links(5));
  left.insert(left.end(), right.begin(), right.end());
  trunk = drawing.closed_row(left, links(10));
  drawing.closed_row(trunk, links(10));
  // One starting row and one split in two.
  EXPECT_EQ(trace_cleanly(drawing.graph()).yarns, 2);
}

}  // namespace
}  // namespace meshknit
