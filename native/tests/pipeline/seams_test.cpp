// Objects whose tubes would have to cross, knit in parts to be sewn.

#include <gtest/gtest.h>

#include <string>
#include <utility>

#include "branching_graphs.h"
#include "lantern.h"
#include "meshknit/core/error.h"
#include "meshknit/knitout/knitout_reader.h"
#include "meshknit/pipeline/part_seams.h"
#include "meshknit/pipeline/pipeline.h"
#include "shapes.h"

namespace meshknit {
namespace {

CheckedGraph checked(KnitGraph graph) {
  CheckedGraph result;
  result.graph = std::move(graph);
  result.check = check_knit_graph(result.graph);
  result.stats = measure_graph(result.graph);
  return result;
}

struct Sewn {
  StitchTrace trace;
  CheckedKnitout file;
  std::vector<KnitPart> parts;
  std::vector<PartSeam> seams;
};

Sewn knit(const CheckedGraph& graph, const std::string& name) {
  const MachineProfile machine = machine_profile(name);
  Sewn sewn;
  sewn.trace = build_trace(graph.graph, machine);
  const Schedule schedule = build_schedule(sewn.trace, machine);
  sewn.file = build_knitout(sewn.trace, schedule, machine, nullptr, graph.seams);
  const Program program = read_knitout(sewn.file.text).program;
  sewn.parts = find_parts(program, sewn.trace, machine);
  sewn.seams = find_part_seams(graph.seams, sewn.parts, program, sewn.trace);
  return sewn;
}

void expect_crossing(const CheckedGraph& graph) {
  const MachineProfile machine = machine_profile("shima_swg091n2");
  try {
    build_schedule(build_trace(graph.graph, machine), machine);
    FAIL() << "the tubes cross";
  } catch (const NotKnittable& refused) {
    EXPECT_NE(find_problem(refused.problems(), "tubes-cross"), nullptr);
  }
}

TEST(SewnObjects, ACutTubeEndsBelowItsSeamAndStartsAboveIt) {
  for (const char* const machine : {"shima_swg091n2", "kniterate"}) {
    const CheckedGraph graph = cut_seams(checked(crossed_pairs(6, 4, true)));
    ASSERT_EQ(graph.seams.size(), 1u);
    const Sewn sewn = knit(graph, machine);
    EXPECT_TRUE(sewn.file.check.ok);
    ASSERT_EQ(sewn.seams.size(), 1u);
    const PartSeam& seam = sewn.seams.front();
    EXPECT_EQ(sewn.parts[seam.lower].ends, 6);
    EXPECT_EQ(sewn.parts[seam.upper].starts, 6);
    EXPECT_TRUE(sewn.parts[seam.lower].into.empty());
    EXPECT_TRUE(sewn.parts[seam.upper].from.empty());
    EXPECT_LT(seam.lower_line, seam.upper_line);
  }
}

TEST(SewnObjects, TheSheetSaysWhatToSewAndWhereToBegin) {
  const Sewn sewn = knit(cut_seams(checked(crossed_pairs(6, 4, true))), "shima_swg091n2");
  const PartSeam& seam = sewn.seams.front();
  const std::string lower = std::to_string(seam.lower + 1),
                    upper = std::to_string(seam.upper + 1);
  for (const std::string& words :
       {"The end of part " + lower + ", 6 loops, to the beginning of part " + upper +
            ", 6 loops",
        "Above part " + lower +
            " unravel the waste down to the object; 6 loops come free: keep",
        "Below part " + upper +
            " cut the waste and pull it out; 6 loops of the object come free: "
            "keep",
        "line " + std::to_string(seam.lower_line) + " and the one of line " +
            std::to_string(seam.upper_line),
        std::string("Above part 11 unravel the waste down to the "
                    "object; 24 loops come free: bind")})
    EXPECT_NE(sewn.file.sheet.find(words), std::string::npos) << words << sewn.file.sheet;
}

TEST(SewnObjects, WhatCanHangIsLeftAlone) {
  const CheckedGraph graph = checked(crossed_pairs(6, 4, false));
  const CheckedGraph same = cut_seams(graph);
  EXPECT_TRUE(same.seams.empty());
  EXPECT_EQ(same.graph.columns, graph.graph.columns);
}

// Nothing crosses in space, and still no order on the bed is without a crossing.
TEST(SewnObjects, ALanternIsKnitWithOneSeamRoundALimb) {
  const TimedShape timed = meshknit::timed(scaled(lantern(), 0.5));
  const CheckedGraph whole = build_knit_graph(timed.surface, timed.time, {});
  const Problem* const proposal = find_problem(whole.check.problems, "seam-needed");
  ASSERT_NE(proposal, nullptr);
  EXPECT_EQ(proposal->severity, Severity::warning);
  EXPECT_NE(proposal->message.find("One seam"), std::string::npos) << proposal->message;
  expect_crossing(whole);

  const CheckedGraph graph = cut_seams(whole);
  ASSERT_EQ(graph.seams.size(), 1u);
  EXPECT_EQ(find_problem(graph.check.problems, "seam-needed"), nullptr);
  const Problem* const seam = find_problem(graph.check.problems, "seam");
  ASSERT_NE(seam, nullptr);
  EXPECT_EQ(seam->elements.nodes, proposal->elements.nodes);
  // Round one of the four limbs, whose axes are 19 mm from both planes between them (half size).
  const Eigen::Vector3d& at = graph.seams.front().middle;
  EXPECT_GT(at.z(), 60.0);
  EXPECT_LT(at.z(), 125.0);
  for (const int node : seam->elements.nodes)
    EXPECT_LT((graph.graph.nodes[node].position - at).norm(), 13.0);

  const Sewn sewn = knit(graph, "shima_swg091n2");
  EXPECT_TRUE(sewn.file.check.ok);
  EXPECT_EQ(sewn.parts.size(), 11u);  // 10 tubes, one of them in two pieces
}

}  // namespace
}  // namespace meshknit
