// Every rule of the check has a file that breaks only it, or nothing else but what follows from that.

#include <gtest/gtest.h>

#include <algorithm>
#include <filesystem>
#include <fstream>
#include <iterator>
#include <map>
#include <regex>
#include <set>
#include <string>
#include <vector>

#include "meshknit/verify/verify_knitout.h"
#include "verify/broken_copy.h"
#include "verify/worked_example.h"

namespace meshknit {
namespace {

using Codes = std::set<std::string>;

// Small additions to the worked example, each wrong in one way. An anchor of its own carrier does
// not touch the object.
const std::vector<BrokenCopy>& additions() {
  static const std::vector<BrokenCopy> copies = {
      {"a carrier that stays in", "carrier-not-out",
       [](auto& k) {
         k.before("stitch 8", {"in 6", "tuck - f15 6 ;!source: anchor", "drop f15"});
       }},
      {"a yarn taken out while the hook holds another", "hook-busy",
       [](auto& k) {
         k.before("outhook 5", {"inhook 6"});
         k.before("drop f16",
                  {"tuck - f9 6 ;!source: anchor", "releasehook 6", "outhook 6", "drop f9"});
       }},
      {"a hook that holds a yarn in the end", "hook-not-released",
       [](auto& k) {
         const std::vector<std::string> left = {"inhook 6", "tuck - f9 6 ;!source: anchor",
                                                "drop f9"};
         k.lines().insert(k.lines().end(), left.begin(), left.end());
       }},
      {"a second yarn for a hook that holds one", "second-hook",
       [](auto& k) {
         k.before("releasehook 5", {"inhook 6", "tuck - f18 6 ;!source: anchor",
                                    "releasehook 6", "outhook 6", "drop f18"});
         k.remove("releasehook 5");
       }},
      {"two carriers in a loop", "several-carriers",
       [](auto& k) {
         k.before("stitch 8",
                  {"in 6 7", "tuck - f15 6 7 ;!source: anchor", "drop f15", "out 6 7"});
       }},
      {"two carriers that come in together and knit one by one", "wrong-first-set",
       [](auto& k) {
         k.before("stitch 8", {"in 6 7", "tuck - f15 6 ;!source: anchor",
                               "tuck - f15 7 ;!source: anchor", "drop f15", "out 6 7"});
       }},
      {"a loop over its neighbour and back", "loop-passes-over",
       [](auto& k) {
         k.before("xfer f10 b10", {"xfer f12 b12", "rack 3", "xfer b12 f15", "xfer f15 b12",
                                   "rack 0", "xfer b12 f12"});
       }},
      {"three tenths of a needle", "racking-fraction",
       [](auto& k) {
         k.lines().insert(k.lines().end(), {"rack 0.3", "rack 0"});
       }},
      {"nine needles", "racking-too-far",
       [](auto& k) {
         k.lines().insert(k.lines().end(), {"rack 9", "rack 0"});
       }},
      {"two anchors on a slider", "slider-stack",
       [](auto& k) {
         k.before("xfer f10 b10",
                  {"in 6", "tuck - f20 6 ;!source: anchor", "tuck - f19 6 ;!source: anchor",
                   "out 6", "xfer f20 bs20", "rack -1", "xfer f19 bs20", "rack 0",
                   "xfer bs20 f20", "drop f20"});
       }},
      {"an anchor from slider to slider", "slider-to-slider",
       [](auto& k) {
         k.before("xfer f10 b10",
                  {"in 6", "tuck - b20 6 ;!source: anchor", "out 6", "xfer b20 fs20",
                   "xfer fs20 bs20", "xfer bs20 f20", "drop f20"});
       }},
      {"an anchor made on a slider", "stitch-on-slider",
       [](auto& k) {
         k.before("stitch 8", {"in 6", "tuck - fs20 6 ;!source: anchor", "out 6", "drop fs20"});
       }},
      {"an anchor moved along its bed", "transfer-same-bed",
       [](auto& k) {
         k.before("xfer f10 b10", {"in 6", "tuck - f20 6 ;!source: anchor", "out 6",
                                   "xfer f20 f22", "drop f22"});
       }},
      {"an anchor through a gap that is not there", "not-aligned",
       [](auto& k) {
         k.before("xfer f10 b10", {"in 6", "tuck - f20 6 ;!source: anchor", "out 6",
                                   "xfer f20 b22", "drop b22"});
       }},
      {"two and two anchors on a needle", "stack-too-high",
       [](auto& k) {
         const std::string front = "tuck - f20 6 ;!source: anchor";
         const std::string back = "tuck - b20 6 ;!source: anchor";
         k.before("xfer f10 b10",
                  {"in 6", front, front, back, back, "out 6", "xfer f20 b20", "drop b20"});
       }},
      {"three loops on a needle", "stack-high",
       [](auto& k) {
         const std::string tuck = "tuck + b17 5 ;!source: waste";
         k.before("stitch 0", {tuck, tuck});
       }},
      {"an empty needle dropped", "drop-from-empty",
       [](auto& k) { k.lines().push_back("drop f20"); }},
      {"another machine's gauge", "other-gauge",
       [](auto& k) { k.before(";;Position", {";;Gauge: 7"}); }},
      {"loops moved while the hook holds a yarn", "transfer-before-release",
       [](auto& k) {
         k.before("releasehook 5", {"xfer f16 b16", "xfer b16 f16"});
       }},
  };
  return copies;
}

// What cannot be wrong alone: the code, and what follows from it or leads to it.
const std::map<std::string, Codes>& never_alone() {
  static const std::map<std::string, Codes> codes = {
      // A hook that holds a yarn in the end has a carrier that is in.
      {"hook-not-released", {"carrier-not-out"}},
      // A loop that is lost is missed by the stitch above it, and hangs or runs elsewhere.
      {"knit-on-empty", {"start-not-on-waste"}},
      // What is no waste and no empty needle is an anchor.
      {"start-not-on-waste", {"anchor-in-object"}},
      {"loop-dropped", {"knit-on-empty", "wrong-parents"}},
      {"tuck-on-empty", {"loops-left", "wrong-parents"}},
      {"merge-of-strangers", {"knit-on-empty", "wrong-parents"}},
      {"wrong-kind", {"wrong-parents"}},
      // What hangs elsewhere is knit through by another stitch.
      {"start-leaves-gap", {"wrong-parents"}},
      {"increase-not-on-empty", {"knit-on-empty", "wrong-parents", "increase-not-beside"}},
      {"increase-not-beside",
       {"float-too-long", "knit-on-empty", "loops-left", "wrong-parents"}},
      // A stitch too few or too many puts all that follow it in another's place.
      {"stitch-count", {"source-mismatch", "wrong-parents", "wrong-kind", "loop-dropped"}},
      {"waste-through-object",
       {"stitch-count", "source-mismatch", "wrong-parents", "wrong-kind", "waste-under-object",
        "loop-dropped"}},
      {"waste-under-object",
       {"stitch-count", "source-mismatch", "wrong-parents", "wrong-kind", "start-not-on-waste",
        "loop-dropped"}},
  };
  return codes;
}

// Rules that other tests keep: of the Kniterate's files, of .kc files, of the trace that a file is
// compared with, and one that needs a tube in another.
const std::map<std::string, std::string>& kept_elsewhere() {
  static const std::map<std::string, std::string> files = {
      {"no-hook", "kniterate_test.cpp"},
      {"no-sliders", "kniterate_test.cpp"},
      {"racking-wide", "kniterate_test.cpp"},
      {"setting-out-of-range", "kniterate_test.cpp"},
      {"setting-unknown", "kniterate_test.cpp"},
      {"waste-too-short", "kniterate_test.cpp"},
      {"no-draw-thread", "kniterate_test.cpp"},
      {"narrow-start", "kniterate_test.cpp"},
      {"bad-kcode", "kcode_check_test.cpp"},
      {"kcode-differs", "kcode_check_test.cpp"},
      {"carrier-elsewhere", "kcode_check_test.cpp"},
      {"carrier-in-the-way", "kcode_check_test.cpp"},
      {"bad-trace", "verify_knitout_test.cpp"},
      {"yarn-count", "verify_knitout_test.cpp"},
      {"carrier-inside-tube", "tubes_test.cpp"},
  };
  return files;
}

std::string text_of(const std::filesystem::path& path) {
  std::ifstream file(path);
  return {std::istreambuf_iterator<char>(file), {}};
}

// The codes that the sources of the check name: all their texts that look like one.
Codes rules() {
  const std::filesystem::path folder =
      std::filesystem::path(MESHKNIT_NATIVE_DIR) / "meshknit" / "verify";
  const std::regex code("\"([a-z]+(-[a-z]+)+|overstretched)\"");
  Codes codes;
  for (const auto& entry : std::filesystem::directory_iterator(folder)) {
    if (entry.path().extension() != ".cpp") continue;
    const std::string text = text_of(entry.path());
    for (std::sregex_iterator at(text.begin(), text.end(), code), end; at != end; ++at)
      codes.insert((*at)[1]);
  }
  codes.erase("more-problems");  // counts those of other rules
  return codes;
}

// [code] what every file that is meant to break it does break.
std::map<std::string, std::vector<Codes>> broken_by_files() {
  std::map<std::string, std::vector<Codes>> found;
  const MachineProfile profile = machine_profile("shima_swg091n2");
  const auto judge = [&](const std::vector<BrokenCopy>& copies, const KnitoutLines& good,
                         const StitchTrace& trace) {
    for (const BrokenCopy& copy : copies) {
      KnitoutLines lines = good;
      copy.damage(lines);
      Codes codes;
      for (const Problem& p : verify_knitout(lines.text(), profile, trace).problems)
        if (p.code != "more-problems") codes.insert(p.code);
      EXPECT_TRUE(codes.count(copy.code) > 0) << copy.what;
      found[copy.code].push_back(codes);
    }
  };
  for (const auto& copies : {copies_of_primers_list(), further_copies(), additions()})
    judge(copies, KnitoutLines(), worked_trace());
  judge(copies_of_branches(), KnitoutLines::branches(), branches_trace());
  return found;
}

TEST(Rules, EveryOneHasAFileThatBreaksOnlyIt) {
  const auto found = broken_by_files();
  const Codes all = rules();
  EXPECT_GT(all.size(), 60u);
  for (const std::string& code : all) {
    if (const auto file = kept_elsewhere().find(code); file != kept_elsewhere().end()) {
      const std::filesystem::path test =
          std::filesystem::path(MESHKNIT_NATIVE_DIR) / "tests" / "verify" / file->second;
      EXPECT_NE(text_of(test).find("\"" + code + "\""), std::string::npos) << code;
      continue;
    }
    Codes allowed{code};
    if (const auto more = never_alone().find(code); more != never_alone().end())
      allowed.insert(more->second.begin(), more->second.end());
    const auto files = found.find(code);
    if (files == found.end()) {
      ADD_FAILURE() << code << " has no file";
      continue;
    }
    bool good = false, alone = false;
    std::string others;
    for (const Codes& codes : files->second) {
      good |= std::includes(allowed.begin(), allowed.end(), codes.begin(), codes.end());
      alone |= codes == Codes{code};
      for (const std::string& other : codes) others += other + " ";
      others += "/ ";
    }
    EXPECT_TRUE(good) << code << " comes with others: " << others;
    EXPECT_TRUE(allowed.size() == 1 || !alone) << code << " can be broken alone";
  }
}

}  // namespace
}  // namespace meshknit
