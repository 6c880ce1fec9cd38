#include <gtest/gtest.h>

#include <algorithm>

#include "graphs.h"
#include "meshknit/tracing/trace.h"
#include "meshknit/tracing/trace_checks.h"

namespace meshknit {
namespace {

StitchTrace trace_cleanly(const KnitGraph& graph) {
  const StitchTrace trace = trace_knit_graph(graph);
  const Problems problems = check_trace(graph, trace);
  EXPECT_TRUE(problems.empty()) << problems.front().code << ": " << problems.front().message;
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

TEST(TraceSplits, ShortRowsOnAnArmTuckOnThatArmOnly) {
  // Wherever the short row lies: where the arms part, its tucks go round its own arm, not over
  // to the other.
  for (const bool on_right : {false, true})
    for (int begin = 0; begin < 6; ++begin) {
      GraphDrawing drawing;
      auto trunk = drawing.cast_on(12);
      trunk = drawing.short_row(trunk, 2, "||||");
      trunk = drawing.closed_row(trunk, links(12));
      auto left = drawing.closed_row({trunk.begin(), trunk.begin() + 6}, "||||||");
      auto right = drawing.closed_row({trunk.begin() + 6, trunk.end()}, "||||||");
      auto& arm = on_right ? right : left;
      const std::vector<int> beside = {arm[(begin + 3) % 6], arm[(begin + 5) % 6]};
      arm = drawing.short_row(arm, begin, "|||");
      drawing.closed_row(right, "||||||");
      drawing.closed_row(left, "||||||");
      const KnitGraph graph = drawing.graph();
      const StitchTrace trace = trace_cleanly(graph);
      EXPECT_EQ(trace.yarns, 2);
      std::vector<int> tucked;
      for (const Stitch& stitch : trace.stitches)
        if (stitch.kind == StitchKind::tuck && stitch.node >= 16) tucked.push_back(stitch.node);
      // Nodes 0-15 are the trunk's first row and its short row, whose tucks lie there.
      EXPECT_TRUE(
          std::is_permutation(tucked.begin(), tucked.end(), beside.begin(), beside.end()))
          << on_right << " " << begin;
    }
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
