#include <gtest/gtest.h>

#include <string>
#include <vector>

#include "graphs.h"
#include "meshknit/tracing/trace.h"
#include "meshknit/verify/verify_knitout.h"
#include "verify/in_place_knitter.h"
#include "verify/worked_example.h"

namespace meshknit {
namespace {

VerifyReport verify(const KnitoutLines& lines) {
  return verify_knitout(lines.text(), machine_profile("shima_swg091n2"), branches_trace());
}

TEST(Branches, ATubeThatPartsAndMeetsAgainIsGood) {
  const VerifyReport report = verify(KnitoutLines::branches());
  for (const Problem& p : report.problems) ADD_FAILURE() << p.code << ": " << p.message;
  EXPECT_TRUE(report.ok);
  // 56 stitches with a loop each; all but the 8 starts go through one.
  EXPECT_EQ(report.loops, 56);
  EXPECT_EQ(report.edges, 48);
}

void expect_good(const VerifyReport& report) {
  for (const Problem& p : report.problems) ADD_FAILURE() << p.code << ": " << p.message;
  EXPECT_TRUE(report.ok);
}

std::string first_code(const VerifyReport& report) {
  return report.problems.empty() ? "" : report.problems.front().code;
}

// Stitch 10 is the last one that the yarn comes to from f14, which will be the right tube's.
TEST(Branches, WhatIsLeftOfARoundMayStepAsideWhenNoYarnCrossesAnyMore) {
  for (const bool early : {false, true}) {
    KnitoutLines lines = KnitoutLines::branches();
    lines.before(early ? "stitch 10" : "stitch 11", {"xfer f14 b14", "xfer f16 b16"});
    lines.before("stitch 18", {"xfer b14 f14", "xfer b16 f16"});
    EXPECT_EQ(first_code(verify(lines)), early ? "tube-order" : "");
  }
}

// From stitch 39 on both tubes wait to be one; then loops of both may mingle on a bed as those of
// one tube do.
TEST(Branches, TubesThatAreDueToMeetMayBeMovedAsOne) {
  for (const bool early : {false, true}) {
    KnitoutLines lines = KnitoutLines::branches();
    lines.before(early ? "stitch 24" : "stitch 40",
                 {"rack 2", "xfer f14 b12", "xfer b12 f14", "rack 0"});
    EXPECT_EQ(first_code(verify(lines)), early ? "passes-other-tube" : "");
  }
}

// As far as its profile says what is different: no hook, no sliders, carriers from the left.
TEST(Branches, AMachineWithoutHookBringsYarnsInFromTheSide) {
  MachineProfile machine = machine_profile("shima_swg091n2");
  machine.machine_header = "";
  machine.carriers = {"1", "2", "3", "4", "5", "6"};
  machine.has_inserting_hook = machine.has_sliders = machine.first_stitch_leftward = false;
  machine.quarter_pitch = 0.5;
  KnitoutLines lines = KnitoutLines::branches();
  lines.remove(";;Machine").replace(" 7 8 9 10", "");
  const auto check = [&] { return verify_knitout(lines.text(), machine, branches_trace()); };
  EXPECT_EQ(first_code(check()), "no-hook");
  lines.replace_all("inhook", "in").replace_all("outhook", "out");
  lines.remove("releasehook").remove("releasehook");
  EXPECT_EQ(first_code(check()), "first-stitch-direction");
  lines.replace("tuck - f16 5", "tuck + f16 5").replace("tuck - f21 6", "tuck + f21 6");
  expect_good(check());
  lines.replace("rack 2", "rack 2.25");
  EXPECT_EQ(first_code(check()), "racking-fraction");
}

// Places one after another round a tube.
std::vector<Needle> ring(const std::vector<std::vector<Needle>>& parts) {
  std::vector<Needle> needles;
  for (const auto& part : parts) needles.insert(needles.end(), part.begin(), part.end());
  return needles;
}

VerifyReport verify_in_place(const KnitGraph& graph,
                             const std::vector<std::vector<Needle>>& rounds) {
  const StitchTrace trace = trace_knit_graph(graph);
  std::string text;
  for (const std::string& line : knit_in_place(trace, rounds)) text += line + "\n";
  return verify_knitout(text, machine_profile("shima_swg091n2"), trace);
}

TEST(Branches, TrousersAreGoodEitherWayUp) {
  // Each leg has three places on the front and three on the back.
  const auto left = ring({back_places(10, 3), front_places(10, 3)});
  const auto right = ring({front_places(13, 3), back_places(13, 3)});
  expect_good(verify_in_place(splitting_tube(6), {ring({left, right})}));
  expect_good(verify_in_place(merging_tube(6), {left, right}));
}

TEST(Branches, ThreeLegsSideBySideAreGood) {
  expect_good(
      verify_in_place(three_way_split(6, 3, 6, 3),
                      {ring({back_places(10, 3), front_places(10, 3), front_places(13, 3),
                             front_places(16, 3), back_places(16, 3), back_places(13, 3)})}));
}

// Where the yarn climbs from row to row has nothing to do with where the tubes part.
TEST(Branches, AHandleIsGoodWhereverTheYarnClimbs) {
  for (int seam = 0; seam < 12; ++seam) {
    SCOPED_TRACE(seam);
    GraphDrawing drawing;
    auto trunk = drawing.cast_on(12);
    trunk = drawing.closed_row(trunk, links(12), seam);
    GraphDrawing::Front left(trunk.begin(), trunk.begin() + 6);
    GraphDrawing::Front right(trunk.begin() + 6, trunk.end());
    for (int row = 0; row < 2; ++row) {
      left = drawing.closed_row(left, links(6), (seam + row) % 6);
      right = drawing.closed_row(right, links(6), (seam + 3 * row) % 6);
    }
    left.insert(left.end(), right.begin(), right.end());
    drawing.closed_row(drawing.closed_row(left, links(12), seam), links(12));
    expect_good(
        verify_in_place(drawing.graph(), {ring({back_places(10, 3), front_places(10, 3),
                                                front_places(13, 3), back_places(13, 3)})}));
  }
}

}  // namespace
}  // namespace meshknit
