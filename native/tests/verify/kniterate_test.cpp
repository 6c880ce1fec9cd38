// The check on the Kniterate: the worked example in a mirror, without a hook, and what this machine
// wants to have knit before the object.

#include <gtest/gtest.h>

#include <regex>
#include <string>
#include <vector>

#include "meshknit/emit/emit_program.h"
#include "meshknit/knitout/knitout_writer.h"
#include "meshknit/verify/verify_knitout.h"
#include "schedule/tube_knitter.h"
#include "verify/broken_copy.h"
#include "verify/worked_example.h"

namespace meshknit {
namespace {

// Needles f10..f16 and b11..b17 go to f18..f12 and b17..b11; what faced each other at racking R does
// at -R.
std::string mirrored(std::string line) {
  std::smatch found;
  std::string image;
  const std::regex needle("\\b([fb])([0-9]+)\\b");
  while (std::regex_search(line, found, needle)) {
    image += found.prefix().str() + found[1].str() + std::to_string(28 - std::stoi(found[2]));
    line = found.suffix();
  }
  image += line;
  image = std::regex_replace(image, std::regex("^(knit|tuck) \\+"), "$1 >");
  image = std::regex_replace(image, std::regex("^(knit|tuck) -"), "$1 +");
  image = std::regex_replace(image, std::regex("^(knit|tuck) >"), "$1 -");
  return std::regex_replace(image, std::regex("rack 2"), "rack -2");
}

KnitoutLines worked_lines() {
  KnitoutLines lines;
  for (std::string& line : lines.lines()) {
    line = mirrored(line);
    line = std::regex_replace(line, std::regex("^(knit|tuck)(.*) 5 "), "$1$2 3 ");
  }
  lines.replace("1 2 3 4 5 6 7 8 9 10", "1 2 3 4 5 6").replace("SWG091N2", "Kniterate");
  return lines.replace("inhook 5", "in 3").replace("outhook 5", "out 3").remove("releasehook");
}

StitchTrace worked_image() {
  StitchTrace trace = worked_trace();
  for (Stitch& stitch : trace.stitches)
    stitch.direction = stitch.direction == Direction::clockwise ? Direction::anticlockwise
                                                                : Direction::clockwise;
  return trace;
}

// The example has a round of waste, and no draw thread.
MachineProfile without_take_down() {
  MachineProfile profile = machine_profile("kniterate");
  profile.take_down_rounds = profile.take_down_width = 0;
  profile.draw_carrier.clear();
  return profile;
}

void expect_only(const char* what, const std::string& code, const VerifyReport& report) {
  const Problem* problem = find_problem(report.problems, code);
  if (!problem) ADD_FAILURE() << what << ": no " << code;
  for (const Problem& other : report.problems)
    if (other.code != "more-problems") {
      EXPECT_EQ(other.code, code) << what << ": " << other.message;
    }
}

TEST(KniterateCheck, TheWorkedExampleIsGoodInAMirror) {
  const VerifyReport report =
      verify_knitout(worked_lines().text(), without_take_down(), worked_image());
  EXPECT_TRUE(report.ok);
  for (const Problem& p : report.problems) ADD_FAILURE() << p.code << ": " << p.message;
  EXPECT_EQ(report.loops, 54);  // 53 stitches, one of them an increase
}

TEST(KniterateCheck, EveryRuleOfTheMachineHasAFileThatBreaksOnlyIt) {
  const std::vector<BrokenCopy> copies = {
      {"a hook that is not there", "no-hook", [](auto& k) { k.replace("out 3", "outhook 3"); }},
      {"a slider that is not there", "no-sliders",
       [](auto& k) {
         k.replace("xfer f18 b18", "xfer f18 bs18").replace("xfer b18", "xfer bs18");
       }},
      {"a first stitch leftward, away from where carriers come from", "first-stitch-direction",
       [](auto& k) { k.replace("tuck + f12", "tuck - f12"); }},
      {"racking 5", "racking-too-far",
       [](auto& k) {
         k.lines().insert(k.lines().end(), {"rack 5", "rack 0"});
       }},
      {"a quarter of a needle, where the machine has halves", "racking-fraction",
       [](auto& k) {
         k.lines().insert(k.lines().end(), {"rack 0.25", "rack 0"});
       }},
      {"beyond the last needle", "needle-outside",
       [](auto& k) { k.before("stitch 8", {"amiss f253"}); }},
      {"the Shima's carriers", "wrong-carriers",
       [](auto& k) { k.replace("1 2 3 4 5 6", "1 2 3 4 5 6 7 8 9 10"); }},
      {"the Shima's name", "wrong-machine",
       [](auto& k) { k.replace("Kniterate", "SWG091N2"); }},
      {"faster than the machine", "setting-out-of-range",
       [](auto& k) { k.before("in 3", {"x-speed-number 700"}); }},
      {"a stitch size that is no hexadecimal digit", "setting-out-of-range",
       [](auto& k) { k.before("in 3", {"x-stitch-number G"}); }},
  };
  for (const BrokenCopy& copy : copies) {
    KnitoutLines lines = worked_lines();
    copy.damage(lines);
    const VerifyReport report =
        verify_knitout(lines.text(), without_take_down(), worked_image());
    EXPECT_FALSE(report.ok) << copy.what;
    expect_only(copy.what, copy.code, report);
  }
}

TEST(KniterateCheck, SettingsAndRackingsThatTheMachineHasPass) {
  KnitoutLines lines = worked_lines();
  lines.before("in 3", {"x-speed-number 600", "x-stitch-number F", "x-roller-advance 0",
                        "x-end-pass", "x-carrier-stopping-distance 2.5"});
  lines.lines().insert(lines.lines().end(), {"rack 0.5", "rack -1.5", "rack 0"});
  const VerifyReport report = verify_knitout(lines.text(), without_take_down(), worked_image());
  EXPECT_TRUE(report.ok && report.problems.empty());
}

TEST(KniterateCheck, RackingsThatMayBreakYarnAndForeignSettingsAreWarnedOf) {
  KnitoutLines lines = worked_lines();
  lines.lines().insert(lines.lines().end(), {"rack 3", "rack 0"});
  VerifyReport report = verify_knitout(lines.text(), without_take_down(), worked_image());
  EXPECT_TRUE(report.ok);
  expect_only("racking 3", "racking-wide", report);

  lines = worked_lines();
  lines.before("in 3", {"x-presser-mode auto"});
  report = verify_knitout(lines.text(), without_take_down(), worked_image());
  EXPECT_TRUE(report.ok);
  expect_only("a presser that is not there", "setting-unknown", report);
}

// 30 loops at half gauge: 15 places, 30 needles wide.
struct Emitted {
  StitchTrace trace = knit_plain_tube(30, 4);
  MachineProfile machine = machine_profile("kniterate");
  KnitoutLines lines(const MachineProfile& made_for) const {
    const Schedule schedule = schedule_stitches(trace, made_for);
    return KnitoutLines(write_knitout(emit_program(trace, schedule, made_for)));
  }
};

TEST(KniterateCheck, AFileOfOursBeginsAsTheMachineNeedsIt) {
  const Emitted tube;
  KnitoutLines lines = tube.lines(tube.machine);
  const VerifyReport report = verify_knitout(lines.text(), tube.machine, tube.trace);
  EXPECT_TRUE(report.ok);
  for (const Problem& p : report.problems) ADD_FAILURE() << p.code << ": " << p.message;
  // Waste, draw thread, object, waste: each comes in once and goes out before the next.
  std::vector<std::string> carriers;
  for (const std::string& line : lines.lines())
    if (line.rfind("in ", 0) == 0 || line.rfind("out ", 0) == 0) carriers.push_back(line);
  EXPECT_EQ(carriers, (std::vector<std::string>{"in 6", "out 6", "in 1", "out 1", "in 2",
                                                "out 2", "in 6", "out 6"}));
}

TEST(KniterateCheck, AFileThatDoesNotReachTheRollersIsRefused) {
  const Emitted tube;
  MachineProfile short_waste = tube.machine;
  short_waste.take_down_rounds = tube.machine.take_down_rounds - 5;
  const VerifyReport report =
      verify_knitout(tube.lines(short_waste).text(), tube.machine, tube.trace);
  EXPECT_FALSE(report.ok);
  expect_only("five courses short", "waste-too-short", report);
}

TEST(KniterateCheck, AFileWithoutDrawThreadIsRefused) {
  const Emitted tube;
  MachineProfile no_thread = tube.machine;
  no_thread.draw_carrier.clear();
  const VerifyReport report =
      verify_knitout(tube.lines(no_thread).text(), tube.machine, tube.trace);
  EXPECT_FALSE(report.ok);
  expect_only("no draw thread", "no-draw-thread", report);
}

TEST(KniterateCheck, ATubeTooNarrowForTheRollersIsWarnedOf) {
  // 12 loops: 6 places, 12 needles.
  const StitchTrace trace = knit_plain_tube(12, 4);
  const MachineProfile machine = machine_profile("kniterate");
  const std::string text =
      write_knitout(emit_program(trace, schedule_stitches(trace, machine), machine));
  const VerifyReport report = verify_knitout(text, machine, trace);
  EXPECT_TRUE(report.ok);
  expect_only("narrow tube", "narrow-start", report);
}

}  // namespace
}  // namespace meshknit
