// The whole way on the Kniterate: 252 needles a bed, six carriers, no hook.

#include <gtest/gtest.h>

#include <regex>
#include <string>
#include <vector>

#include "branching_graphs.h"
#include "graphs.h"
#include "meshknit/core/error.h"
#include "meshknit/pipeline/pipeline.h"
#include "random_surfaces.h"
#include "shapes.h"

namespace meshknit {
namespace {

const MachineProfile& kniterate() {
  static const MachineProfile profile = machine_profile("kniterate");
  return profile;
}

CheckedKnitout knit(const KnitGraph& graph, const MachineProfile& machine = kniterate()) {
  const StitchTrace trace = build_trace(graph, machine);
  return build_knitout(trace, build_schedule(trace, machine), machine);
}

KnitGraph graph_of(const std::string& name, double size, double stitches = 1.0) {
  const RemeshOptions options = gauge(stitches);
  const TimedShape shape = timed(
      opened(scaled(example_shape(name), size), options.stitch_width), options.stitch_width);
  return build_knit_graph(shape.surface, shape.time, options).graph;
}

class OnTheKniterate : public testing::TestWithParam<std::string> {};
INSTANTIATE_TEST_SUITE_P(Pipeline, OnTheKniterate, testing::ValuesIn(example_shape_names()),
                         [](const auto& shape) { return shape.param; });

TEST_P(OnTheKniterate, EveryExampleEndsInFilesThatTheMachineTakes) {
  for (const double stitches : {1.0, 2.0}) {
    SCOPED_TRACE(stitches);
    const CheckedKnitout file = knit(graph_of(GetParam(), 1.0, stitches));
    EXPECT_TRUE(file.check.ok);
    EXPECT_LE(file.cost.max_racking, 2.0);  // more may break yarn
    EXPECT_GE(file.cost.lowest_needle, 1);
    EXPECT_LE(file.cost.highest_needle, 252);
    EXPECT_EQ(file.kcode.rfind("HOME\n", 0), 0u);
    EXPECT_GE(file.kcode_sweeps,
              file.cost.passes);  // carriers have to be brought to their side
    for (const char* hook : {"inhook", "releasehook", "outhook", " fs", " bs"})
      EXPECT_EQ(file.text.find(hook), std::string::npos) << hook;
    // Draw thread, waste, and no more than four others.
    const std::vector<std::string>& used = file.cost.carriers;
    EXPECT_EQ(used.front(), "1");
    EXPECT_EQ(used.back(), "6");
    EXPECT_LE(used.size(), 6u);
  }
}

TEST(Kniterate, SmallTubesThatPartAndMeetKnitWithoutError) {
  for (int a = 3; a <= 9; ++a) {
    EXPECT_TRUE(knit(splitting_tube(a)).check.ok) << a;
    EXPECT_TRUE(knit(merging_tube(a)).check.ok) << a;
    EXPECT_TRUE(knit(tube_with_hole(a, 12 - a, 3)).check.ok) << a;
  }
  EXPECT_TRUE(knit(three_legs(6, 7, 8, 5, 1)).check.ok);
  EXPECT_TRUE(knit(three_legs_upside_down(7, 9, 6, 4)).check.ok);
}

TEST(Kniterate, MoreLegsThanCarriersAreKnitInTurn) {
  // A trunk that sheds six legs one after another; four carriers are free for yarn.
  const StitchTrace trace = build_trace(many_legs(6, 6, 12), kniterate());
  EXPECT_EQ(trace.yarns, 6);
  const CheckedKnitout file =
      build_knitout(trace, build_schedule(trace, kniterate()), kniterate());
  EXPECT_TRUE(file.check.ok);
  EXPECT_LE(file.cost.carriers.size(), 6u);
}

// 252 needles: 126 places, the first without a needle 0, four free at each end: 117 places a bed,
// 234 loops round a tube.
TEST(Kniterate, WhatDoesNotFitIsRefusedWithTheLargestScale) {
  const auto refusal = [](double size) -> std::string {
    try {
      const TimedShape ring = timed(straight_tube(30.0 * size, 20.0));
      knit(build_knit_graph(ring.surface, ring.time, {}).graph);
      return "";
    } catch (const NotKnittable& refused) {
      const Problem* wide = find_problem(refused.problems(), "too-wide");
      return wide ? wide->message + " " + wide->remedy : "another reason";
    }
  };
  // A ring of radius 30 is 2 pi 30 / 3.66 = 51.5 loops round: five times as wide, 258.
  const std::string text = refusal(5.0);
  EXPECT_NE(text.find("room for 234"), std::string::npos) << text;
  std::smatch found;
  ASSERT_TRUE(std::regex_search(text, found, std::regex("to ([0-9]+) %"))) << text;
  const double fits = 5.0 * std::stod(found[1]) / 100.0;
  EXPECT_EQ(refusal(fits), "");
  EXPECT_NE(refusal(fits + 0.1), "");
}

TEST(Kniterate, RandomSurfacesEndInCheckedFilesOrInAReason) {
  int knitted = 0;
  for (std::uint32_t seed = 0; seed < 10; ++seed) {
    const RandomSurface drawn = random_surface(seed);
    try {
      const KnitGraph graph =
          build_knit_graph(drawn.timed.surface, drawn.timed.time, drawn.gauge).graph;
      EXPECT_TRUE(knit(graph).check.ok) << "seed " << seed;
      ++knitted;
    } catch (const NotKnittable& refused) {
      for (const Problem& p : refused.problems())
        EXPECT_FALSE(p.code.empty() || p.remedy.empty()) << "seed " << seed;
    }
  }
  EXPECT_GE(knitted, 5);
}

TEST(Kniterate, RackingsThatStrainYarnAreUsedOnlyWhereNothingElseHelps) {
  // With none that it likes, the machine must still be able to shape.
  MachineProfile stiff = kniterate();
  stiff.liked_racking = 0;
  const CheckedKnitout file = knit(graph_of("cone", 1.0, 2.0), stiff);
  EXPECT_TRUE(file.check.ok);
  EXPECT_GT(file.cost.max_racking, 0.0);
  EXPECT_NE(find_problem(file.check.problems, "racking-wide"), nullptr);
}

TEST(Kniterate, SettingsThatTheMachineDoesNotHaveAreAnErrorOfTheProfile) {
  MachineProfile fast = kniterate();
  for (const std::string setting : {"x-speed-number 700", ""}) {
    fast.first_settings = {setting};
    EXPECT_THROW(knit(plain_tube(20, 4), fast), InvalidInput) << '"' << setting << '"';
  }
}

// What the same object is on the two machines: the stitches are the same, loop by loop.
TEST(Kniterate, TheShimaKnitsTheSameStitches) {
  const KnitGraph graph = three_legs(6, 7, 8, 5, 1);
  const CheckedKnitout there = knit(graph, machine_profile("shima_swg091n2"));
  const CheckedKnitout here = knit(graph);
  EXPECT_EQ(there.check.loops, here.check.loops);
  EXPECT_EQ(there.check.edges, here.check.edges);
  EXPECT_TRUE(there.kcode.empty());
  EXPECT_NE(there.text.find("inhook"), std::string::npos);
}

}  // namespace
}  // namespace meshknit
