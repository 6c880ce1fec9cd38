#include "meshknit/verify/verify_knitout.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <string>
#include <utility>

#include "meshknit/core/error.h"
#include "verify/worked_example.h"

namespace meshknit {
namespace {

VerifyReport verify(const KnitoutLines& lines, const StitchTrace& trace = worked_trace()) {
  return verify_knitout(lines.text(), machine_profile("shima_swg091n2"), trace);
}

TEST(VerifyKnitout, TheWorkedExampleIsGood) {
  const VerifyReport report = verify(KnitoutLines());
  for (const Problem& p : report.problems) ADD_FAILURE() << p.code << ": " << p.message;
  EXPECT_TRUE(report.ok);
  // 53 stitches, one of them with two loops.
  EXPECT_EQ(report.loops, 54);
  // Every loop has one parent, but for 8 starts, 2 tucks and the increase's second loop; the
  // decrease and the two stitches that pick up tucks have two: 54 - 11 + 3.
  EXPECT_EQ(report.edges, 46);
  EXPECT_EQ(report.max_stack, 2);
  // The alternating cast-on skips every second place: 4 needles.
  EXPECT_EQ(report.max_stretch, 4);
}

TEST(VerifyKnitout, ThreeLoopsOnANeedleAreWarnedOfOnly) {
  KnitoutLines lines;
  lines.before("stitch 0", {"tuck + b17 5 ;!source: waste", "tuck + b17 5 ;!source: waste"});
  const VerifyReport report = verify(lines);
  EXPECT_TRUE(report.ok);
  EXPECT_EQ(report.warnings, 1);
  EXPECT_NE(find_problem(report.problems, "stack-high"), nullptr);
  EXPECT_EQ(report.max_stack, 3);
}

TEST(VerifyKnitout, WasteMayBeKnitThroughTheEnds) {
  KnitoutLines lines;
  lines.replace("outhook 5", "knit - f16 5 ;!source: waste");
  lines.before("drop f16", {"outhook 5"});
  EXPECT_TRUE(verify(lines).ok);
}

TEST(VerifyKnitout, AnAnchorBesideTheObjectMayBeDropped) {
  KnitoutLines lines;
  lines.before("stitch 8", {"tuck - f15 5 ;!source: anchor"});
  lines.before("stitch 16", {"drop f15"});
  EXPECT_TRUE(verify(lines).ok);
}

TEST(VerifyKnitout, ProblemsNameTheirLineAndStitch) {
  KnitoutLines lines;
  lines.replace("knit - f14 5 ;!source: stitch 9", "knit + f14 5 ;!source: stitch 9");
  const VerifyReport report = verify(lines);
  ASSERT_EQ(report.problems.size(), 1u);
  EXPECT_EQ(report.problems[0].code, "wrong-direction");
  EXPECT_EQ(report.problems[0].elements.lines, std::vector<int>{lines.find("stitch 9") + 1});
  EXPECT_EQ(report.problems[0].elements.stitches, std::vector<int>{9});
}

TEST(VerifyKnitout, ASecondYarnIsComparedToo) {
  // From the second round (stitch 8) on with carrier 6.
  KnitoutLines lines;
  const int second = lines.find("stitch 8");
  for (std::size_t k = static_cast<std::size_t>(second); k < lines.lines().size(); ++k) {
    std::string& line = lines.lines()[k];
    const std::size_t carrier = line.find(" 5");
    if (carrier != std::string::npos) line.replace(carrier, 2, " 6");
  }
  lines.before("stitch 8", {"outhook 5", "inhook 6"}).before("stitch 9", {"releasehook 6"});
  StitchTrace trace = worked_trace();
  trace.yarns = 2;
  for (std::size_t s = 8; s < trace.stitches.size(); ++s) trace.stitches[s].yarn = 1;
  EXPECT_TRUE(verify(lines, trace).ok);
  trace.stitches[8].yarn = 0;
  EXPECT_NE(find_problem(verify(lines, trace).problems, "stitch-count"), nullptr);
}

TEST(VerifyKnitout, AFloodOfProblemsIsCountedButNotListed) {
  // Without stitch 1 each of the 51 stitches after it stands in another's place.
  KnitoutLines lines;
  lines.remove("stitch 1");
  const VerifyReport report = verify(lines);
  EXPECT_GE(report.errors, 51);
  const auto listed =
      std::count_if(report.problems.begin(), report.problems.end(),
                    [](const Problem& p) { return p.code == "source-mismatch"; });
  EXPECT_LT(listed, 51);
  EXPECT_NE(find_problem(report.problems, "more-problems"), nullptr);
}

TEST(VerifyKnitout, AnotherTraceIsNotWhatWasKnit) {
  const auto code = [](auto&& change) {
    StitchTrace trace = worked_trace();
    change(trace);
    const VerifyReport report = verify(KnitoutLines(), trace);
    EXPECT_FALSE(report.ok);
    return report.problems.empty() ? std::string() : report.problems.front().code;
  };
  // The two loops of the increase exchanged.
  EXPECT_EQ(code([](StitchTrace& t) {
              std::swap(t.stitches[40].children[0], t.stitches[40].children[1]);
            }),
            "wrong-parents");
  // The decrease meets its loops the other way.
  EXPECT_EQ(code([](StitchTrace& t) {
              std::swap(t.stitches[18].parents[0], t.stitches[18].parents[1]);
            }),
            "wrong-stack-order");
  // A tuck that the stitch above should meet before its own loop.
  EXPECT_EQ(code([](StitchTrace& t) {
              std::swap(t.stitches[34].parents[0], t.stitches[34].parents[1]);
            }),
            "wrong-stack-order");
  EXPECT_EQ(code([](StitchTrace& t) { t.stitches[20].direction = Direction::anticlockwise; }),
            "wrong-direction");
  EXPECT_EQ(code([](StitchTrace& t) {
              for (int k = 45; k < 53; ++k) t.stitches[k].yarn = 1;
              t.yarns = 2;
            }),
            "yarn-count");
  // A trace that does not agree with itself is not compared with.
  EXPECT_EQ(code([](StitchTrace& t) { t.stitches[20].parents = {14}; }), "bad-trace");
  EXPECT_EQ(code([](StitchTrace& t) { t.stitches[20].parents = {-4}; }), "bad-trace");
  EXPECT_EQ(code([](StitchTrace& t) { t.stitches[20].kind = StitchKind::end; }), "bad-trace");
}

TEST(VerifyKnitout, EmptyTextIsRefusedAndAnEmptyTraceIsNotAnExcuse) {
  const MachineProfile profile = machine_profile("shima_swg091n2");
  EXPECT_FALSE(verify_knitout("", profile, StitchTrace()).ok);
  EXPECT_FALSE(verify_knitout(KnitoutLines().text(), profile, StitchTrace()).ok);
}

TEST(VerifyKnitout, CanBeCancelled) {
  RunContext run;
  run.cancel();
  EXPECT_THROW(verify_knitout(KnitoutLines().text(), machine_profile("shima_swg091n2"),
                              worked_trace(), &run),
               Cancelled);
}

}  // namespace
}  // namespace meshknit
