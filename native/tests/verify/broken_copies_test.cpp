#include <gtest/gtest.h>

#include <cstdint>
#include <string>
#include <utility>
#include <vector>

#include "meshknit/verify/verify_knitout.h"
#include "verify/broken_copy.h"
#include "verify/worked_example.h"

namespace meshknit {

// The primer's list (end of section 7).
const std::vector<BrokenCopy>& copies_of_primers_list() {
  static const std::vector<BrokenCopy> copies = {
      {"stray drop", "loop-dropped", [](auto& k) { k.before("stitch 17", {"drop f14"}); }},
      {"transfer at wrong racking", "not-aligned",
       [](auto& k) { k.replace("rack 2", "rack 1"); }},
      {"same-bed transfer", "transfer-same-bed",
       [](auto& k) { k.replace("xfer b10 f12", "xfer b10 b12"); }},
      {"missing in", "carrier-not-in", [](auto& k) { k.remove("inhook 5"); }},
      {"double in", "carrier-already-in", [](auto& k) { k.before("stitch 8", {"in 5"}); }},
      {"never out", "carrier-not-out", [](auto& k) { k.remove("outhook 5"); }},
      {"loops left", "loops-left", [](auto& k) { k.remove("drop b13"); }},
      {"racking 9", "racking-too-far", [](auto& k) { k.replace("rack 2", "rack 9"); }},
      {"racking 0.3", "racking-fraction", [](auto& k) { k.replace("rack 2", "rack 0.3"); }},
      {"transfer at quarter pitch", "transfer-at-quarter-pitch",
       [](auto& k) { k.before("xfer f10 b10", {"rack 0.25"}); }},
      {"knit on empty", "knit-on-empty",
       [](auto& k) { k.replace("f10 5 ;!source: stitch 11", "f8 5 ;!source: stitch 11"); }},
      {"transfer from empty", "transfer-from-empty",
       [](auto& k) { k.before("xfer f10 b10", {"xfer f8 b8"}); }},
      {"stack of five", "stack-too-high",
       [](auto& k) {
         const std::string tuck = "tuck + b17 5 ;!source: waste";
         k.before("stitch 0", {tuck, tuck, tuck, tuck});
       }},
      {"stack of four", "stack-too-high",
       [](auto& k) {
         const std::string tuck = "tuck + b17 5 ;!source: waste";
         k.before("stitch 0", {tuck, tuck, tuck});
       }},
      {"slider knit", "stitch-on-slider",
       [](auto& k) {
         k.replace("knit - f16 5 ;!source: stitch 8", "knit - fs16 5 ;!source: stitch 8");
       }},
      {"60-needle float", "float-too-long",
       [](auto& k) {
         k.before("stitch 8", {"tuck - f77 5 ;!source: anchor", "drop f77"});
       }},
      {"hook never released", "hook-not-released", [](auto& k) { k.remove("releasehook 5"); }},
      {"second hook", "second-hook", [](auto& k) { k.before("releasehook 5", {"inhook 6"}); }},
      {"release of another carrier", "wrong-release",
       [](auto& k) { k.replace("releasehook 5", "releasehook 6"); }},
      {"release before a stitch", "wrong-release",
       [](auto& k) { k.remove("releasehook 5").before("tuck - f16", {"releasehook 5"}); }},
      {"stitch right of the hook", "stitch-right-of-hook",
       [](auto& k) { k.remove("releasehook 5").before("stitch 0", {"releasehook 5"}); }},
      {"first stitch rightward", "first-stitch-direction",
       [](auto& k) { k.replace("tuck - f16", "tuck + f16"); }},
      {"split at wrong racking", "not-aligned",
       [](auto& k) {
         k.replace("knit - f10 5 ;!source: stitch 11", "split - f10 b13 5 ;!source: stitch 11");
       }},
      {"forgotten stitch", "stitch-count", [](auto& k) { k.remove("stitch 20"); }},
      {"two stitches swapped in order", "source-mismatch",
       [](auto& k) { k.swap("stitch 13", "stitch 14"); }},
      {"two stitches swapped, comments put right", "wrong-parents",
       [](auto& k) {
         k.swap("stitch 13", "stitch 14")
             .replace("stitch 14", "stitch X")
             .replace("stitch 13", "stitch 14");
         k.replace("stitch X", "stitch 13");
       }},
      {"two loops swapped by transfers", "wrong-parents",
       [](auto& k) {
         k.before("xfer f10 b10", {"xfer f12 b12", "xfer f14 b14", "rack 2", "xfer b12 f14",
                                   "rack -2", "xfer b14 f12", "rack 0"});
       }},
      {"two loops swapped by transfers, seen under way", "loop-passes-over",
       [](auto& k) {
         k.before("xfer f10 b10", {"xfer f12 b12", "xfer f14 b14", "rack 2", "xfer b12 f14",
                                   "rack -2", "xfer b14 f12", "rack 0"});
       }},
      {"one loop carried 24 needles away", "overstretched",
       [](auto& k) {
         k.before("xfer f10 b10",
                  {"rack -4", "xfer f16 b20", "rack 4", "xfer b20 f24", "rack -4",
                   "xfer f24 b28", "rack 4", "xfer b28 f32", "rack -4", "xfer f32 b36",
                   "rack 4", "xfer b36 f40", "rack 0"});
       }},
      {"front loop merged onto an occupied back needle", "merge-of-strangers",
       [](auto& k) {
         k.before("xfer f10 b10", {"rack 1", "xfer f14 b13", "rack 0"});
       }},
  };
  return copies;
}

// Rules that only this project has, or that the list leaves out.
const std::vector<BrokenCopy>& further_copies() {
  static const std::vector<BrokenCopy> copies = {
      {"waste carrying on through the object", "waste-through-object",
       [](auto& k) { k.replace("stitch 20", "waste"); }},
      {"waste carrying on under the object", "waste-under-object",
       [](auto& k) { k.replace("stitch 4", "waste"); }},
      {"no source comment", "source-missing",
       [](auto& k) { k.replace(" ;!source: stitch 20", ""); }},
      {"another stitch's comment", "source-mismatch",
       [](auto& k) { k.replace("stitch 20", "stitch 21"); }},
      {"direction swapped", "wrong-direction",
       [](auto& k) {
         k.replace("knit + b13 5 ;!source: stitch 20", "knit - b13 5 ;!source: stitch 20");
       }},
      {"increase's second loop tucked the same way", "wrong-direction",
       [](auto& k) { k.replace("tuck + f10", "tuck - f10"); }},
      {"increase's second loop on a loop", "increase-not-on-empty",
       [](auto& k) { k.replace("tuck + f10", "tuck + f14"); }},
      {"increase's second loop at the other end", "increase-not-beside",
       [](auto& k) { k.replace("tuck + f10", "tuck + b19"); }},
      {"short-row tuck beside its loop", "tuck-on-empty",
       [](auto& k) { k.replace("tuck - b11", "tuck - b9"); }},
      {"short-row tuck on the next loop but one", "wrong-parents",
       [](auto& k) { k.replace("tuck - b11", "tuck - b13"); }},
      {"knit where a tuck is due", "wrong-kind",
       [](auto& k) { k.replace("tuck - b11", "knit - b11"); }},
      {"decrease stacked the other way", "wrong-stack-order",
       [](auto& k) {
         k.before("rack 2", {"xfer f12 b12"})
             .before("knit - f16 5 ;!source: stitch 16", {"xfer b12 f12"});
       }},
      {"object knit together with an anchor", "anchor-in-object",
       [](auto& k) { k.before("stitch 8", {"tuck - f16 5 ;!source: anchor"}); }},
      {"starts on anchors instead of waste", "start-not-on-waste",
       [](auto& k) { k.replace("waste", "anchor"); }},
      {"starts out of turn", "start-leaves-gap",
       [](auto& k) {
         k.replace("f14 5 ;!source: stitch 1", "f12 5 ;!source: stitch 1")
             .replace("f12 5 ;!source: stitch 2", "f14 5 ;!source: stitch 2");
       }},
      {"stitches made while a loop is parked", "tube-order",
       [](auto& k) {
         k.before("stitch 16", {"xfer f14 b14"}).before("stitch 17", {"xfer b14 f14"});
       }},
      {"last loop dropped while its yarn is in", "end-dropped-early",
       [](auto& k) { k.remove("drop f14").before("outhook 5", {"drop f14"}); }},
      {"carrier out without a stitch", "carrier-without-stitch",
       [](auto& k) {
         k.before("stitch 8", {"in 6", "out 6"});
       }},
      {"out with a busy hook", "hook-busy",
       [](auto& k) { k.swap("releasehook 5", "outhook 5"); }},
      {"several carriers in a loop", "several-carriers",
       [](auto& k) {
         k.before("inhook 5", {"in 6"})
             .replace("knit - f16 5 ;!source: stitch 8", "knit - f16 5 6 ;!source: stitch 8");
       }},
      {"carrier used without the one it came in with", "wrong-first-set",
       [](auto& k) {
         k.before("stitch 8", {"in 6 7", "tuck - f15 6 ;!source: anchor", "drop f15"});
       }},
      {"miss with a carrier that is out", "carrier-not-in",
       [](auto& k) { k.before("stitch 8", {"miss - f16 6"}); }},
      {"needle outside the bed", "needle-outside",
       [](auto& k) { k.before("stitch 8", {"amiss f541"}); }},
      {"slider to slider", "slider-to-slider",
       [](auto& k) { k.replace("xfer f10 b10", "xfer fs10 bs10"); }},
      {"two loops on a slider", "slider-stack",
       [](auto& k) {
         k.before("xfer f10 b10", {"xfer f12 bs12", "rack -2", "xfer f10 bs12", "rack 0"});
       }},
      {"another machine's carriers", "wrong-carriers",
       [](auto& k) { k.replace("8 9 10", "8 9"); }},
      {"another machine", "wrong-machine", [](auto& k) { k.replace("SWG091N2", "Kniterate"); }},
      {"racking that overstretches the bridges", "overstretched",
       // f10 and b11 are neighbours on the yarn. b11 goes to f15 (5 needles away, just in
       // reach) and on to b16, which stands at 15 at racking -1 but at 16 at racking 0.
       [](auto& k) {
         k.before("xfer f10 b10",
                  {"rack 4", "xfer b11 f15", "rack -1", "xfer f15 b16", "rack 0"});
       }},
      {"unreadable line", "unknown-operation",
       [](auto& k) { k.before("stitch 8", {"purl f3"}); }},
  };
  return copies;
}

namespace {

TEST(BrokenCopies, EveryOneOfThePrimersListIsRefusedByItsRule) {
  expect_refused(copies_of_primers_list(), KnitoutLines(), worked_trace());
}

TEST(BrokenCopies, FurtherRulesRefuseWhatBreaksThem) {
  expect_refused(further_copies(), KnitoutLines(), worked_trace());
}

TEST(BrokenCopies, MachinesWithoutHookOrSlidersRefuseThem) {
  MachineProfile plain = machine_profile("shima_swg091n2");
  plain.has_inserting_hook = false;
  plain.has_sliders = false;
  KnitoutLines lines;
  lines.replace("xfer f10 b10", "xfer f10 bs10").replace("xfer b10 f12", "xfer bs10 f12");
  const VerifyReport report = verify_knitout(lines.text(), plain, worked_trace());
  EXPECT_NE(find_problem(report.problems, "no-hook"), nullptr);
  EXPECT_NE(find_problem(report.problems, "no-sliders"), nullptr);
  // With both, parking on the slider is as good as on the hook.
  EXPECT_TRUE(
      verify_knitout(lines.text(), machine_profile("shima_swg091n2"), worked_trace()).ok);
}

TEST(BrokenCopies, EveryForgottenLoopIsNoticed) {
  const MachineProfile profile = machine_profile("shima_swg091n2");
  const std::size_t count = KnitoutLines().lines().size();
  for (std::size_t k = 0; k < count; ++k) {
    KnitoutLines lines;
    const std::string line = lines.lines()[k];
    if (line.find(";!source: stitch") == std::string::npos) continue;
    lines.lines().erase(lines.lines().begin() + static_cast<std::ptrdiff_t>(k));
    EXPECT_FALSE(verify_knitout(lines.text(), profile, worked_trace()).ok) << line;
  }
}

// A fixed generator of our own, so that every run sees the same damage.
class Lcg {
 public:
  std::size_t below(std::size_t n) {
    state_ = state_ * 6364136223846793005ULL + 1442695040888963407ULL;
    return static_cast<std::size_t>(state_ >> 33) % n;
  }

 private:
  std::uint64_t state_ = 42;
};

TEST(BrokenCopies, NoTextMakesTheCheckThrow) {
  const MachineProfile profile = machine_profile("shima_swg091n2");
  const std::vector<std::string> spice = {
      "xfer f14 b13",  "rack 1",        "rack -0.75",  "drop b13",     "split - f12 b12 5",
      "releasehook 5", "outhook 5",     "inhook 5",    "in 6 5",       "xfer bs3 f4",
      "tuck + b17 7",  "knit - fs10 5", "miss + f1 3", "xfer f12 f12", "knit + f999999 5",
      "xfer b10 f10"};
  Lcg random;
  for (int round = 0; round < 6000; ++round) {
    const bool branches = round % 2 == 1;
    KnitoutLines copy = branches ? KnitoutLines::branches() : KnitoutLines();
    const StitchTrace trace = branches ? branches_trace() : worked_trace();
    std::vector<std::string>& lines = copy.lines();
    for (std::size_t wounds = 1 + random.below(8); wounds > 0; --wounds) {
      const std::size_t at = random.below(lines.size());
      const auto here = lines.begin() + static_cast<std::ptrdiff_t>(at);
      switch (random.below(4)) {
        case 0:
          lines.erase(here);
          break;
        case 1:
          lines.insert(here, spice[random.below(spice.size())]);
          break;
        case 2:
          std::swap(lines[at], lines[random.below(lines.size())]);
          break;
        default:
          lines.insert(here, std::string(lines[random.below(lines.size())]));
          break;
      }
    }
    const VerifyReport report = verify_knitout(copy.text(), profile, trace);
    ASSERT_EQ(report.ok, !has_errors(report.problems));
    for (const Problem& p : report.problems) {
      ASSERT_FALSE(p.code.empty() || p.message.empty() || p.remedy.empty());
    }
  }
}

}  // namespace
}  // namespace meshknit
