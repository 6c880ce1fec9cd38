// Copies of the example that parts and meets again; each breaks one of the rules that only several
// tubes have.

#include <gtest/gtest.h>

#include <string>
#include <vector>

#include "verify/broken_copy.h"

namespace meshknit {
namespace {

// From stitch `first` on the left tube is knit as f10 b11 b13 f12 instead of f12 f10 b11 b13.
void turn_left_tube(KnitoutLines& lines, int first) {
  const char* const right[] = {"- f12", "- f10", "+ b11", "+ b13"};
  for (int k = 0; k < 4; ++k) {
    const std::string rest = " 6 ;!source: stitch " + std::to_string(first + k);
    lines.replace(right[k] + rest, right[(k + 1) % 4] + rest);
  }
}

}  // namespace

const std::vector<BrokenCopy>& copies_of_branches() {
  static const std::vector<BrokenCopy> all = {
      // The left tube is f10 f12 b11 b13, the right one f14 f16 b15 b17.
      {"a loop brought between the other tube's and back", "passes-other-tube",
       [](auto& k) {
         k.before("stitch 24", {"rack 2", "xfer f14 b12", "xfer b12 f14", "rack 0"});
       },
       true},
      {"a loop put on the other tube's needle", "merge-of-strangers",
       [](auto& k) {
         k.before("stitch 24", {"rack 1", "xfer f14 b13", "rack 0"});
       }},
      {"waste cast on across the right tube", "tubes-interleaved",
       [](auto& k) {
         k.before("stitch 24",
                  {"inhook 7", "tuck - f15 7 ;!source: waste", "releasehook 7",
                   "tuck + b14 7 ;!source: waste", "outhook 7", "drop f15", "drop b14"});
       },
       true},
      // f10 goes to f8; at racking 3 its neighbour b11 stands at 14, six needles away.
      {"an idle tube's bridge overstretched by a racking", "overstretched",
       [](auto& k) {
         k.before("stitch 24", {"rack 1", "xfer f10 b9", "rack -1", "xfer b9 f8", "rack 3",
                                "rack -1", "xfer f8 b9", "rack 1", "xfer b9 f10", "rack 0"});
       },
       true},
      {"a stitch of the right tube knit in the left one", "wrong-parents",
       [](auto& k) { k.replace("b15 6 ;!source: stitch 26", "b13 6 ;!source: stitch 26"); }},
      {"a loop of the right tube given to the left one", "wrong-parents",
       [](auto& k) { k.replace("b13 5 ;!source: stitch 17", "b15 5 ;!source: stitch 17"); },
       true},
      {"tubes that meet with one of them turned by a loop", "wrong-parents",
       [](auto& k) { turn_left_tube(k, 42); }, true},
      {"the same with the loops brought along", "tube-order",
       [](auto& k) {
         k.before("stitch 40",
                  {"xfer f10 b10", "xfer f12 b12", "rack -1", "xfer b13 f12", "rack -2",
                   "xfer b12 f10", "rack 0", "xfer b11 f11", "rack -2", "xfer f11 b13",
                   "rack 1", "xfer b10 f11", "rack 0", "xfer f11 b11"});
         for (const int first : {42, 50}) turn_left_tube(k, first);
       },
       true},
      {"a carrier brought in again while its yarn is in", "carrier-already-in",
       [](auto& k) { k.replace_all("hook 6", "hook 5").replace_all(" 6 ;", " 5 ;"); }},
      {"a yarn that goes on with the other tube", "stitch-count",
       [](auto& k) { k.replace("b15 6 ;!source: stitch 26", "b15 5 ;!source: stitch 26"); }},
      // The second yarn is anchored left of the left tube, so it lies across that tube.
      {"yarn through a tube", "yarn-through-tube",
       [](auto& k) {
         k.replace("tuck - f21", "tuck - f9").replace("tuck - f19", "tuck - f7");
         k.replace("tuck + f20", "tuck + f8");
         k.replace("drop f21", "drop f9").replace("drop f19", "drop f7");
         k.replace("drop f20", "drop f8");
       },
       true},
      {"waste dropped while the object hangs on it", "waste-dropped-early",
       [](auto& k) {
         k.before("drop f16", {"inhook 7", "knit - f16 7 ;!source: waste", "releasehook 7"});
         k.lines().push_back("outhook 7");
       },
       true},
      {"the waste below dropped before the object stands on it", "knit-on-empty",
       [](auto& k) { k.before("stitch 4", {"drop b11"}); }},
      // Two small tubes of waste, f30 b31 and f34 b35: the right one goes to the front bed, the left
      // one behind it and to its other side.
      {"tubes that change places", "tubes-crossed",
       [](auto& k) {
         k.before("stitch 29",
                  {"inhook 7", "tuck - f30 7 ;!source: waste", "releasehook 7",
                   "tuck + b31 7 ;!source: waste", "outhook 7", "inhook 8",
                   "tuck - f34 8 ;!source: waste", "releasehook 8",
                   "tuck + b35 8 ;!source: waste", "outhook 8", "rack 1", "xfer b35 f36",
                   "rack -3", "xfer f30 b33", "rack 4", "xfer b33 f37", "rack 1"});
         k.before("stitch 30", {"drop f37", "drop b31", "drop f34", "drop f36", "rack 0"});
       },
       true},
      {"the second yarn never taken out", "carrier-not-out",
       [](auto& k) { k.remove("outhook 6"); }},
      {"a third yarn's hook while the second's is held", "second-hook",
       [](auto& k) { k.before("releasehook 6", {"inhook 7"}); }},
  };
  return all;
}

namespace {

TEST(BrokenBranches, EveryRuleOfSeveralTubesRefusesWhatBreaksIt) {
  expect_refused(copies_of_branches(), KnitoutLines::branches(), branches_trace());
}

}  // namespace
}  // namespace meshknit
