#include "meshknit/pipeline/run_sheet.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <string>
#include <vector>

#include "branching_graphs.h"
#include "graphs.h"
#include "meshknit/knitout/knitout_reader.h"
#include "meshknit/pipeline/knit_parts.h"

namespace meshknit {
namespace {

struct Knitted {
  StitchTrace trace;
  CheckedKnitout file;
  std::vector<KnitPart> parts;
};

Knitted knit(const KnitGraph& graph, const std::string& name) {
  const MachineProfile machine = machine_profile(name);
  Knitted knitted;
  knitted.trace = build_trace(graph, machine);
  knitted.file = build_knitout(knitted.trace, build_schedule(knitted.trace, machine), machine);
  knitted.parts = find_parts(read_knitout(knitted.file.text).program, knitted.trace, machine);
  return knitted;
}

bool says(const Knitted& knitted, const std::string& words) {
  return knitted.file.sheet.find(words) != std::string::npos;
}

TEST(KnitParts, ATrunkPartsIntoItsLegs) {
  // 6 + 7 + 8 nodes round the trunk; the last leg parts first, then the others from each other.
  const Knitted legs = knit(three_legs(6, 7, 8, 5), "shima_swg091n2");
  ASSERT_EQ(legs.parts.size(), 5u);
  EXPECT_EQ(legs.parts[0].starts, 21);
  EXPECT_TRUE(legs.parts[0].from.empty());
  EXPECT_EQ(legs.parts[0].into.size(), 2u);
  int ends = 0;
  for (const KnitPart& part : legs.parts) {
    ends += part.ends;
    EXPECT_LE(part.lowest, part.highest);
    EXPECT_GT(part.line, 0);
  }
  EXPECT_EQ(ends, 21);
}

TEST(KnitParts, PartsThatMeetGoIntoOne) {
  const Knitted legs = knit(merging_tube(6), "shima_swg091n2");
  ASSERT_EQ(legs.parts.size(), 3u);
  EXPECT_EQ(legs.parts[2].from.size(), 2u);
  for (const int leg : {0, 1})
    EXPECT_EQ(legs.parts[leg].into, std::vector<int>{legs.parts[2].tube});
}

TEST(RunSheet, SaysWhatToThreadWhereItLiesAndWhatToDoAfterwards) {
  // 40 loops round: 20 places, needles 2n to 2(n + 19) + 1; anchors on every second of the five left
  // of them. 45 needles are 45 * 25.4 / 7 = 163 mm.
  const Knitted tube = knit(plain_tube(40, 5), "kniterate");
  for (const char* words :
       {"kniterate, 7 needles an inch, 252 needles a bed", "45 needles, 163 mm",
        "1   draw thread", "2   yarn of the object, for part 1", "3   empty", "6   waste",
        "starts with 40 loops on waste, ends with 40 loops under waste",
        "pull the draw thread; 40 loops", "unravel the waste down to the object; 40 loops",
        "weave in 2 ends", "sweeps of the carriage", "Nothing unusual."})
    EXPECT_TRUE(says(tube, words)) << words << "\n" << tube.file.sheet;
  EXPECT_FALSE(says(tube, "parts further right"));
}

TEST(RunSheet, TheShimaHasNoDrawThread) {
  const Knitted tube = knit(plain_tube(40, 5), "shima_swg091n2");
  EXPECT_TRUE(says(tube, "cut the waste and pull it out")) << tube.file.sheet;
  EXPECT_FALSE(says(tube, "draw thread"));
  EXPECT_FALSE(says(tube, "sweeps"));
}

TEST(RunSheet, WarnsOfNarrowStartsAndLongWaits) {
  // Two legs of 6 loops: 6 needles wide; while the waste of one is knit, 140 passes, the other waits.
  const Knitted legs = knit(merging_tube(6), "kniterate");
  EXPECT_TRUE(says(legs, "the rollers hold 20 or more")) << legs.file.sheet;
  EXPECT_TRUE(says(legs, "loops wait for")) << legs.file.sheet;
  EXPECT_TRUE(says(legs, "goes into 3"));
  EXPECT_TRUE(says(legs, "no seams"));
  int longest = 0;
  for (const KnitPart& part : legs.parts) longest = std::max(longest, part.longest_wait);
  EXPECT_GE(longest, 140);
}

TEST(RunSheet, IsTheSameEveryTime) {
  EXPECT_EQ(knit(three_legs(6, 7, 8, 5), "kniterate").file.sheet,
            knit(three_legs(6, 7, 8, 5), "kniterate").file.sheet);
}

}  // namespace
}  // namespace meshknit
