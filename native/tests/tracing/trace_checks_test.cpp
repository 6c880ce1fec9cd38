#include "meshknit/tracing/trace_checks.h"

#include <gtest/gtest.h>

#include <algorithm>

#include "graphs.h"
#include "meshknit/tracing/trace.h"

namespace meshknit {
namespace {

/// A good trace to break: a tube with an increase, a decrease and a short row.
class TraceChecks : public testing::Test {
 protected:
  TraceChecks() {
    GraphDrawing drawing;
    auto front = drawing.cast_on(8);
    front = drawing.closed_row(front, "||Y||A|");
    front = drawing.short_row(front, 2, "||||");
    front = drawing.closed_row(front, "||||||||");
    graph_ = drawing.graph();
    trace_ = trace_knit_graph(graph_);
  }

  int find(StitchKind kind) const {
    const auto found = std::find_if(trace_.stitches.begin(), trace_.stitches.end(),
                                    [&](const Stitch& s) { return s.kind == kind; });
    return static_cast<int>(found - trace_.stitches.begin());
  }

  /// The code of the first problem; empty if the trace is good.
  std::string code() const {
    const Problems problems = check_trace(graph_, trace_);
    return problems.empty() ? "" : problems.front().code;
  }

  /// Takes a stitch out as if it never was, with all that names it.
  void forget(int s) {
    trace_.stitches.erase(trace_.stitches.begin() + s);
    for (Stitch& stitch : trace_.stitches)
      for (std::vector<int>* names : {&stitch.parents, &stitch.children}) {
        names->erase(std::remove(names->begin(), names->end(), s), names->end());
        for (int& name : *names) name -= name > s;
      }
  }

  /// Exchanges two stitches' places in time.
  void exchange(int a, int b) {
    std::swap(trace_.stitches[a], trace_.stitches[b]);
    for (Stitch& stitch : trace_.stitches)
      for (std::vector<int>* names : {&stitch.parents, &stitch.children})
        for (int& name : *names) name = name == a ? b : name == b ? a : name;
  }

  KnitGraph graph_;
  StitchTrace trace_;
};

TEST_F(TraceChecks, TheTraceIsGoodBeforeItIsBroken) { EXPECT_EQ(code(), ""); }

TEST_F(TraceChecks, ADecreaseTakesItsLoopsInOrder) {
  std::vector<int>& parents = trace_.stitches[find(StitchKind::decrease)].parents;
  std::swap(parents[0], parents[1]);
  EXPECT_EQ(code(), "loops-off-columns");
}

TEST_F(TraceChecks, AnIncreaseNamesItsKnitLoopFirst) {
  std::vector<int>& children = trace_.stitches[find(StitchKind::increase)].children;
  std::swap(children[0], children[1]);
  EXPECT_EQ(code(), "loops-off-columns");
}

TEST_F(TraceChecks, ParentsAndChildrenAgree) {
  trace_.stitches[20].parents[0] -= 1;
  EXPECT_EQ(code(), "family-disagrees");
}

TEST_F(TraceChecks, NoStitchIsForgotten) {
  forget(static_cast<int>(trace_.stitches.size()) - 1);
  EXPECT_EQ(code(), "kind-children") << "its loop is never knit through";
}

TEST_F(TraceChecks, NoNodeIsKnitThreeTimes) {
  Stitch more;
  more.kind = StitchKind::end;
  more.node = trace_.stitches.back().node;
  more.parents = {static_cast<int>(trace_.stitches.size()) - 1};
  trace_.stitches.back().children = {static_cast<int>(trace_.stitches.size())};
  trace_.stitches.back().kind = StitchKind::knit;
  trace_.stitches.push_back(more);
  EXPECT_EQ(code(), "node-not-knit-twice");
}

TEST_F(TraceChecks, NoTuckIsMissing) {
  forget(find(StitchKind::tuck));
  EXPECT_EQ(code(), "yarn-jumps") << "the yarn turns without holding on";
}

TEST_F(TraceChecks, NoTuckTooMuch) {
  // A second tuck right after the first, on the same loop.
  const int tuck = find(StitchKind::tuck);
  Stitch more = trace_.stitches[tuck];
  for (Stitch& stitch : trace_.stitches)
    for (std::vector<int>* names : {&stitch.parents, &stitch.children})
      for (int& name : *names) name += name > tuck;
  trace_.stitches.insert(trace_.stitches.begin() + tuck + 1, more);
  trace_.stitches[tuck + 1].children = trace_.stitches[tuck].children;
  std::vector<int>& parents = trace_.stitches[trace_.stitches[tuck].children[0]].parents;
  parents.insert(std::find(parents.begin(), parents.end(), tuck) + 1, tuck + 1);
  EXPECT_EQ(code(), "tuck-misplaced");
}

TEST_F(TraceChecks, ATuckLiesOnTheLoopBesideTheTurn) {
  // Handed to the stitch after the right one, one loop further round.
  const int tuck = find(StitchKind::tuck);
  const int right = trace_.stitches[tuck].children[0], wrong = right + 1;
  std::vector<int>& from = trace_.stitches[right].parents;
  from.erase(std::find(from.begin(), from.end(), tuck));
  trace_.stitches[wrong].parents.push_back(tuck);
  trace_.stitches[tuck].children = {wrong};
  EXPECT_EQ(code(), "tuck-order") << "the tuck says whose loop it lies on";
  trace_.stitches[tuck].node = trace_.stitches[trace_.stitches[wrong].parents[0]].node;
  EXPECT_EQ(code(), "tuck-misplaced");
}

TEST_F(TraceChecks, ATuckStandsBehindItsLoop) {
  const int tuck = find(StitchKind::tuck);
  std::vector<int>& parents = trace_.stitches[trace_.stitches[tuck].children[0]].parents;
  ASSERT_EQ(parents.size(), 2u);
  std::swap(parents[0], parents[1]);
  EXPECT_EQ(code(), "tuck-order");
}

TEST_F(TraceChecks, TucksOnOneLoopStandInTheOrderOfMaking) {
  // Both short rows over nodes 3-6 turn beside node 7.
  graph_ = stacked_short_rows(2);
  trace_ = trace_knit_graph(graph_);
  std::vector<int>& parents =
      trace_.stitches[trace_.stitches[find(StitchKind::tuck)].children[0]].parents;
  ASSERT_EQ(parents.size(), 3u);
  std::swap(parents[1], parents[2]);
  EXPECT_EQ(code(), "tuck-order");
}

TEST_F(TraceChecks, ATuckBesideADecreaseKeepsToItsLoop) {
  // Nodes 0-9, a short row over 3-6 that tucks on 2, and a decrease over 1 and 2.
  GraphDrawing drawing;
  auto front = drawing.cast_on(10);
  front = drawing.short_row(front, 3, "||||");
  drawing.closed_row(front, "|A|||||||");
  graph_ = drawing.graph();
  trace_ = trace_knit_graph(graph_);
  ASSERT_EQ(code(), "");
  std::vector<int>& parents = trace_.stitches[find(StitchKind::decrease)].parents;
  ASSERT_EQ(parents.size(), 3u);
  std::swap(parents[1], parents[2]);
  trace_.stitches[parents[1]].node = 1;
  EXPECT_EQ(code(), "tuck-misplaced");
}

TEST_F(TraceChecks, AfterATuckTheYarnComesBack) {
  const int tuck = find(StitchKind::tuck);
  exchange(tuck + 1, tuck + 2);
  EXPECT_EQ(code(), "tuck-misplaced");
}

TEST_F(TraceChecks, TheYarnDoesNotSkipAStitch) {
  // Stitches 20 and 21 lie side by side in one round.
  exchange(20, 21);
  EXPECT_EQ(code(), "yarn-jumps");
}

TEST_F(TraceChecks, ClosedRowsGoAnticlockwise) {
  trace_.stitches[20].direction = Direction::clockwise;
  EXPECT_EQ(code(), "closed-row-reversed");
}

TEST_F(TraceChecks, KindsFitTheirNumbers) {
  trace_.stitches[find(StitchKind::decrease)].kind = StitchKind::knit;
  EXPECT_EQ(code(), "kind-parents");
}

TEST_F(TraceChecks, NothingIsKnitBeforeItsParents) {
  trace_.stitches[3].parents = {5};
  EXPECT_EQ(code(), "stitch-before-parent");
  trace_.stitches[3].parents = {};
  trace_.stitches[3].children = {2};
  EXPECT_EQ(code(), "stitch-after-child");
}

TEST_F(TraceChecks, NodesAndYarnsExist) {
  trace_.stitches[3].node = 1000;
  EXPECT_EQ(code(), "stitch-without-node");
  trace_.stitches[3].node = 3;
  trace_.stitches[3].yarn = 1;
  EXPECT_EQ(code(), "stitch-without-yarn");
}

TEST_F(TraceChecks, NoYarnTooMany) {
  // The last round with a yarn of its own; one tube needs one yarn.
  trace_.yarns = 2;
  for (std::size_t i = trace_.stitches.size() - 8; i < trace_.stitches.size(); ++i)
    trace_.stitches[i].yarn = 1;
  EXPECT_EQ(code(), "too-many-yarns");
}

TEST_F(TraceChecks, CoursesAreTwoARow) {
  trace_.courses += 1;
  EXPECT_EQ(code(), "wrong-courses");
}

TEST_F(TraceChecks, AShortRowNeedsItsTurns) {
  // Cut off the yarn right at a turn: the new yarn needs no tuck to begin there.
  const int tuck = find(StitchKind::tuck);
  forget(tuck);
  trace_.yarns = 2;
  for (std::size_t i = tuck; i < trace_.stitches.size(); ++i) trace_.stitches[i].yarn = 1;
  const Problems problems = check_trace(graph_, trace_);
  EXPECT_NE(find_problem(problems, "turn-missing"), nullptr);
}

}  // namespace
}  // namespace meshknit
