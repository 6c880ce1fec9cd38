#include "meshknit/pipeline/pipeline.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <regex>
#include <sstream>

#include "meshknit/core/error.h"
#include "shapes.h"

namespace meshknit {
namespace {

struct Knitted {
  CheckedGraph graph;
  StitchTrace trace;
  CheckedKnitout file;
};

Knitted knit(const TimedShape& shape, const MachineProfile& profile,
             RunContext* run = nullptr) {
  Knitted knitted;
  knitted.graph = build_knit_graph(shape.surface, shape.time, {}, run);
  knitted.trace = build_trace(knitted.graph.graph, profile, run);
  const Schedule schedule = build_schedule(knitted.trace, profile, run);
  knitted.file = build_knitout(knitted.trace, schedule, profile, run);
  return knitted;
}

class WholeWay : public testing::TestWithParam<std::string> {};
INSTANTIATE_TEST_SUITE_P(Pipeline, WholeWay, testing::ValuesIn(shape_names()),
                         [](const auto& shape) { return shape.param; });

TEST_P(WholeWay, EndsInAFileThatTheSimulatedMachineAccepts) {
  const MachineProfile profile = machine_profile("shima_swg091n2");
  for (const double size : shape_sizes) {
    SCOPED_TRACE(size);
    const Knitted knitted = knit(shape_named(GetParam(), size), profile);
    EXPECT_TRUE(knitted.file.check.ok);
    EXPECT_EQ(knitted.file.check.errors, 0);
    // One tube, one yarn; every node is knit twice, and every loop is on the machine.
    EXPECT_EQ(knitted.trace.yarns, 1);
    const auto& stitches = knitted.trace.stitches;
    const auto tucks = std::count_if(stitches.begin(), stitches.end(), [](const Stitch& s) {
      return s.kind == StitchKind::tuck;
    });
    EXPECT_EQ(static_cast<long>(stitches.size()) - tucks, 2 * knitted.graph.stats.nodes);
    EXPECT_EQ(tucks, 2 * knitted.graph.stats.short_rows);
    const auto increases = std::count_if(stitches.begin(), stitches.end(), [](const Stitch& s) {
      return s.kind == StitchKind::increase;
    });
    EXPECT_EQ(knitted.file.check.loops, static_cast<long>(stitches.size()) + increases);
  }
}

TEST(Pipeline, TheSameMeshGivesTheSameFile) {
  const MachineProfile profile = machine_profile("shima_swg091n2");
  for (const char* name : {"sock", "bent_tube", "wobbly_tube"})
    EXPECT_EQ(knit(shape_named(name), profile).file.text,
              knit(shape_named(name), profile).file.text)
        << name;
}

TEST(Pipeline, ATubeThatIsTooWideIsRefusedWithTheSizeThatFits) {
  // 40 needles a bed hold fewer than 20 loops a bed at half gauge; a tube of 51 needs 26.
  MachineProfile narrow = machine_profile("shima_swg091n2");
  narrow.needles = 40;
  const TimedShape shape = shape_named("straight_tube");
  try {
    knit(shape, narrow);
    FAIL() << "40 needles cannot hold a tube of 51 loops";
  } catch (const NotKnittable& refused) {
    const Problem* problem = find_problem(refused.problems(), "too-wide");
    ASSERT_NE(problem, nullptr);
    EXPECT_FALSE(problem->elements.nodes.empty());
    // The size that is offered fits.
    std::smatch found;
    const std::string text = problem->message + " " + problem->remedy;
    ASSERT_TRUE(std::regex_search(text, found, std::regex("([0-9]+) ?%"))) << text;
    const double size = std::stod(found[1]) / 100.0;
    ASSERT_LT(size, 1.0);
    EXPECT_TRUE(knit(shape_named("straight_tube", size), narrow).file.check.ok);
  }
}

TEST(Pipeline, ACancelledRunLeavesNothing) {
  const MachineProfile profile = machine_profile("shima_swg091n2");
  const TimedShape shape = shape_named("bent_tube", 0.5);
  const Knitted knitted = knit(shape, profile);
  const Schedule schedule = build_schedule(knitted.trace, profile);
  RunContext run;
  run.cancel();
  EXPECT_THROW(build_knit_graph(shape.surface, shape.time, {}, &run), Cancelled);
  EXPECT_THROW(build_trace(knitted.graph.graph, profile, &run), Cancelled);
  EXPECT_THROW(build_schedule(knitted.trace, profile, &run), Cancelled);
  EXPECT_THROW(build_knitout(knitted.trace, schedule, profile, &run), Cancelled);
}

TEST(Pipeline, AFieldThatDoesNotRiseIsRefused) {
  const TimedShape shape = shape_named("straight_tube", 0.5);
  const std::vector<double> flat(shape.time.size(), 0.0);
  EXPECT_THROW(build_knit_graph(shape.surface, flat, {}), NotKnittable);
}

// Any stitch, transfer or drop of the object that goes missing is seen.
TEST(Pipeline, AFileThatLostOneLineIsRefused) {
  const MachineProfile profile = machine_profile("shima_swg091n2");
  const Knitted knitted = knit(shape_named("bent_tube", 0.5), profile);
  std::vector<std::string> lines;
  std::istringstream in(knitted.file.text);
  for (std::string line; std::getline(in, line);) lines.push_back(line);
  const auto of_the_object = [](const std::string& line) {
    return line.find("source: stitch") != std::string::npos || line.rfind("xfer", 0) == 0;
  };
  int tried = 0;
  for (std::size_t lost = 0; lost < lines.size(); ++lost) {
    if (!of_the_object(lines[lost]) || lost % 37 != 0) continue;
    std::string text;
    for (std::size_t i = 0; i < lines.size(); ++i)
      if (i != lost) text += lines[i] + "\n";
    EXPECT_FALSE(verify_knitout(text, profile, knitted.trace).ok) << lines[lost];
    ++tried;
  }
  EXPECT_GE(tried, 20);
}

}  // namespace
}  // namespace meshknit
