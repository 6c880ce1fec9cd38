// From graphs and surfaces whose tubes part and meet to programs that the independent check accepts.

#include <gtest/gtest.h>

#include <algorithm>
#include <map>
#include <set>
#include <string>

#include "branching_graphs.h"
#include "emit/knitted_program.h"
#include "graphs.h"
#include "meshknit/core/error.h"
#include "meshknit/emit/emit_program.h"
#include "meshknit/knitout/knitout_writer.h"
#include "meshknit/pipeline/pipeline.h"
#include "meshknit/schedule/schedule_checks.h"
#include "meshknit/tracing/trace.h"
#include "meshknit/verify/verify_knitout.h"
#include "random_surfaces.h"
#include "shapes.h"

namespace meshknit {
namespace {

std::string errors_of_program(const KnitGraph& graph) {
  return meshknit::errors_of_program(trace_knit_graph(graph));
}

Program program_of(const KnitGraph& graph) {
  const StitchTrace trace = trace_knit_graph(graph);
  return emit_program(trace, schedule_stitches(trace, shima()), shima());
}

TEST(BranchesEmit, TubesOfEverySizePartAndMeetWithoutError) {
  for (int a = 3; a <= 12; ++a) {
    ASSERT_EQ(errors_of_program(splitting_tube(a)), "") << a << " loops";
    ASSERT_EQ(errors_of_program(merging_tube(a)), "") << a << " loops";
    for (int b = 3; b <= 12; ++b)
      ASSERT_EQ(errors_of_program(tube_with_hole(a, b, 3)), "") << a << " and " << b;
  }
}

TEST(BranchesEmit, ThreeLegsKnitWithoutErrorBothWays) {
  for (const auto& [a, b, c] : {std::array{6, 6, 6}, {5, 8, 11}, {12, 7, 4}, {9, 9, 9}}) {
    EXPECT_EQ(errors_of_program(three_legs(a, b, c, 4)), "") << a << " " << b << " " << c;
    EXPECT_EQ(errors_of_program(three_legs_upside_down(a, b, c, 4)), "")
        << a << " " << b << " " << c;
  }
  EXPECT_EQ(errors_of_program(three_legs(12, 12, 12, 8, 2)), "") << "widening";
  EXPECT_EQ(errors_of_program(three_legs(20, 20, 20, 6, -2)), "") << "narrowing";
}

TEST(BranchesEmit, ThreeTubesPartInOneRowWithoutError) {
  for (const auto& [a, b, c] : {std::array{6, 3, 6}, {5, 4, 8}, {8, 2, 7}, {12, 6, 4}})
    EXPECT_EQ(errors_of_program(three_way_split(a, b, c, b)), "") << a << " " << b << " " << c;
}

// The yarn of the last common row still holds the three together; moving two of them out of the way
// is less work than moving the large tube, but no such yarn reaches over two places.
TEST(BranchesEmit, TheMiddleOfThreeGetsRoomOnBothSidesBesideALargeTube) {
  for (const int large : {20, 40})
    for (const auto& [a, b, c] : {std::array{6, 4, 6}, {6, 3, 6}, {8, 5, 8}})
      EXPECT_EQ(errors_of_program(three_way_split_beside(large, a, b, c, b)), "")
          << a << " " << b << " " << c << " beside " << large;
}

TEST(BranchesEmit, PairsThatWouldCrossAreKnitInTurn) {
  EXPECT_EQ(errors_of_program(crossed_pairs(4, 5, false)), "");
  EXPECT_EQ(errors_of_program(crossed_pairs(7, 3, false)), "");
}

TEST(BranchesEmit, ShortRowsOnALegKnitWithoutError) {
  GraphDrawing drawing;
  const auto trunk = drawing.closed_row(drawing.cast_on(16), links(16));
  auto left = drawing.closed_row({trunk.begin(), trunk.begin() + 8}, links(8));
  const auto right = drawing.closed_row({trunk.begin() + 8, trunk.end()}, links(8));
  left = drawing.closed_row(drawing.short_row(left, 2, "||||"), links(8));
  drawing.closed_row(left, links(8));
  drawing.closed_row(right, links(8));
  EXPECT_EQ(errors_of_program(drawing.graph()), "");
}

TEST(BranchesEmit, ExampleShapesKnitWithoutError) {
  for (const std::string name :
       {"two_way_split", "two_way_merge", "three_way_split", "three_way_merge", "trousers",
        "mitten", "ring_torus", "teddy"}) {
    const TimedShape shape = timed(opened(example_shape(name)));
    EXPECT_EQ(errors_of_program(remesh(shape.surface, shape.time, {})), "") << name;
  }
}

// All kinds of branching at once. What is refused must have a reason of the shape's own.
TEST(BranchesEmit, RandomSurfacesKnitWithoutErrorOrAreRefused) {
  int knit = 0;
  for (std::uint32_t seed = 0; seed < 20; ++seed) {
    const RandomSurface random = random_surface(seed);
    try {
      const KnitGraph graph = remesh(random.timed.surface, random.timed.time, random.gauge);
      ASSERT_EQ(errors_of_program(graph), "") << "seed " << seed;
      ++knit;
    } catch (const NotKnittable& refused) {
      const std::string code = refused.problems().front().code;
      EXPECT_EQ(code, "splits-here") << "seed " << seed;
    }
  }
  EXPECT_GE(knit, 18);
}

TEST(BranchesEmit, EveryLegHasACarrierOfItsOwnWhileItIsKnit) {
  const Program program = program_of(many_legs(5, 8, 4));
  std::set<std::string> in;
  std::size_t most = 0;
  for (const Instruction& i : program.instructions) {
    if (i.op == Op::inhook) in.insert(i.carriers.front());
    if (i.op == Op::outhook) in.erase(i.carriers.front());
    in.erase(shima().waste_carrier);
    most = std::max(most, in.size());
  }
  EXPECT_EQ(most, 5u);
  EXPECT_TRUE(in.empty());
}

TEST(BranchesEmit, AMachineWithFewCarriersKnitsLegByLeg) {
  MachineProfile few = shima();
  few.carriers = {"1", "2", "3"};
  const KnitGraph graph = many_legs(5, 8, 4);
  const StitchTrace together = trace_knit_graph(graph);
  EXPECT_THROW(emit_program(together, schedule_stitches(together, few), few), NotKnittable);
  const StitchTrace in_turn = trace_knit_graph(graph, 2);
  const std::string text =
      write_knitout(emit_program(in_turn, schedule_stitches(in_turn, few), few));
  EXPECT_EQ(errors_of(verify_knitout(text, few, in_turn).problems), "");
}

// A leg that ends while others go on is closed with waste of its own: as many rounds over its loops
// as over any other, and none over its neighbours'.
TEST(BranchesEmit, WasteIsKnitOverOneLegAtATime) {
  const Program program = program_of(three_legs(6, 8, 10, 4));
  std::map<int, int> waste_loops;  // by waste tube: from its coming in to its going out
  int tube = 0;
  for (const Instruction& i : program.instructions) {
    const bool waste = !i.carriers.empty() && i.carriers.front() == shima().waste_carrier;
    if (waste && i.op == Op::inhook) ++tube;
    if (i.source.kind == Source::Kind::waste) ++waste_loops[tube];
  }
  // Before: a cast-on round and ten plain ones over 24 loops. After: ten over each leg, the first
  // to end first.
  std::multiset<int> after;
  for (const auto& [number, loops] : waste_loops)
    if (number > 1) after.insert(loops);
  EXPECT_EQ(waste_loops[1], 24 * 11);
  EXPECT_EQ(after, (std::multiset<int>{60, 80, 100}));
}

// The tube (or waste) that hangs at a place: -1 for none. Follows a program needle by needle.
class HangingTubes {
 public:
  explicit HangingTubes(const StitchTrace& trace) : trace_(trace) {}

  void run(const Instruction& i) {
    if (i.op == Op::xfer) {
      tube_[i.target] = tube_[i.needle];
      tube_.erase(i.needle);
    } else if (i.op == Op::drop) {
      tube_.erase(i.needle);
    } else if (i.source.kind == Source::Kind::stitch) {
      tube_[i.needle] = trace_.stitches[i.source.stitch].tube;
    } else if (i.source.kind == Source::Kind::waste && tube_.count(i.needle) == 0) {
      tube_[i.needle] = -2;
    }
  }
  int at(const Needle& needle) const {
    const auto found = tube_.find(needle);
    return found == tube_.end() ? -1 : found->second;
  }

 private:
  const StitchTrace& trace_;
  std::map<Needle, int> tube_;
};

TEST(BranchesEmit, AnchorsAreTuckedInNoOtherTube) {
  for (const KnitGraph& graph :
       {three_legs(6, 7, 8, 4), three_legs_upside_down(7, 9, 6, 4), many_legs(5, 8, 4)}) {
    const StitchTrace trace = trace_knit_graph(graph);
    const Program program = emit_program(trace, schedule_stitches(trace, shima()), shima());
    HangingTubes hanging(trace);
    std::vector<Needle> anchors;
    int checked = 0;
    for (const Instruction& i : program.instructions) {
      if (i.source.kind == Source::Kind::anchor) {
        anchors.push_back(i.needle);
        continue;
      }
      const bool first_loop = (i.op == Op::knit || i.op == Op::tuck) && !anchors.empty();
      if (first_loop) {
        // On the tube that the yarn was brought in for. An anchor lies at needle 2n + 1 of the
        // front, beside the hooks f(2n) and b(2n + 1) of place n.
        const int own = hanging.at(i.needle);
        for (const Needle& anchor : anchors)
          for (const Needle& hook : {Needle{Bed::front, anchor.index - 1, false},
                                     Needle{Bed::back, anchor.index, false}}) {
            const int tube = hanging.at(hook);
            EXPECT_TRUE(tube == -1 || tube == own) << to_string(anchor);
            ++checked;
          }
        anchors.clear();
      }
      hanging.run(i);
    }
    EXPECT_GT(checked, 0);
  }
}

TEST(BranchesEmit, TheSameGraphGivesTheSameBytes) {
  const auto text = [] { return write_knitout(program_of(three_legs(7, 8, 9, 5, 1))); };
  EXPECT_EQ(text(), text());
}

}  // namespace
}  // namespace meshknit
