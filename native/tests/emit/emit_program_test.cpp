#include "meshknit/emit/emit_program.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <iterator>
#include <set>
#include <string>
#include <vector>

#include "meshknit/core/error.h"
#include "schedule/tube_knitter.h"

namespace meshknit {
namespace {

const MachineProfile& shima() {
  static const MachineProfile profile = machine_profile("shima_swg091n2");
  return profile;
}

Program emit(const StitchTrace& trace, const MachineProfile& profile = shima()) {
  return emit_program(trace, schedule_stitches(trace, profile), profile);
}

std::vector<Instruction> with(const Program& program, Op op) {
  std::vector<Instruction> found;
  std::copy_if(program.instructions.begin(), program.instructions.end(),
               std::back_inserter(found), [&](const Instruction& i) { return i.op == op; });
  return found;
}

int made_by(const Program& program, Source::Kind kind) {
  return static_cast<int>(std::count_if(
      program.instructions.begin(), program.instructions.end(), [&](const Instruction& i) {
        return (i.op == Op::knit || i.op == Op::tuck) && i.source.kind == kind;
      }));
}

TEST(EmitProgram, APlainTubeIsItsStitchesBetweenTwoWasteTubes) {
  const Program program = emit(knit_plain_tube(10, 6));
  EXPECT_EQ(made_by(program, Source::Kind::stitch), 60);
  // Before: a cast-on round and ten plain ones. After: ten plain ones.
  EXPECT_EQ(made_by(program, Source::Kind::waste), 10 * (1 + 10 + 10));
  // Waste comes in twice, the yarn once, each with three anchors.
  EXPECT_EQ(made_by(program, Source::Kind::anchor), 9);
  EXPECT_TRUE(with(program, Op::xfer).empty());
  EXPECT_TRUE(with(program, Op::rack).empty());
  // Nine anchors and the ten loops of the last waste round.
  EXPECT_EQ(with(program, Op::drop).size(), 19u);
}

TEST(EmitProgram, CarriersComeInOneAfterAnother) {
  const Program program = emit(knit_plain_tube(10, 6));
  std::vector<std::string> order;
  for (const Instruction& i : program.instructions)
    if (i.op == Op::inhook || i.op == Op::releasehook || i.op == Op::outhook)
      order.push_back(i.carriers.front());
  const std::string w = shima().waste_carrier, y = shima().yarn_carrier;
  EXPECT_EQ(order, (std::vector<std::string>{w, w, w, y, y, y, w, w, w}));
  EXPECT_EQ(program.carriers, shima().carriers);
}

TEST(EmitProgram, AMachineWithoutAHookUsesPlainInAndOut) {
  MachineProfile profile = shima();
  profile.has_inserting_hook = false;
  profile.first_stitch_leftward = false;
  const Program program = emit(knit_plain_tube(10, 6), profile);
  EXPECT_TRUE(with(program, Op::inhook).empty());
  EXPECT_TRUE(with(program, Op::releasehook).empty());
  EXPECT_EQ(with(program, Op::in).size(), 3u);
  EXPECT_EQ(with(program, Op::out).size(), 3u);
  // Every carrier's first stitch goes the way that this machine asks for.
  for (size_t i = 0; i + 1 < program.instructions.size(); ++i) {
    if (program.instructions[i].op == Op::in) {
      EXPECT_EQ(program.instructions[i + 1].direction, Side::right);
    }
  }
}

TEST(EmitProgram, NothingIsWorkedBeyondTheHookBeforeItsRelease) {
  const Program program = emit(knit_one_sided_cone(20, 12));
  int hook = 0;
  for (const Instruction& i : program.instructions) {
    if (i.op == Op::inhook) hook = -1;
    if (i.op == Op::releasehook) hook = 0;
    if (i.op != Op::knit && i.op != Op::tuck) continue;
    if (hook == -1) {
      EXPECT_EQ(i.direction, Side::left) << "the hook brings the yarn from the right";
      hook = i.needle.index + 1;
    }
    if (hook > 0) {
      EXPECT_LT(i.needle.index, hook);
    }
  }
}

TEST(EmitProgram, NoAnchorHangsWhileLoopsAreTransferred) {
  // Decreases in the very first round after the start.
  const Program program = emit(TubeKnitter(20).decrease().knit(18).end());
  ASSERT_FALSE(with(program, Op::xfer).empty());
  std::set<Needle> anchors;
  for (const Instruction& i : program.instructions) {
    if (i.source.kind == Source::Kind::anchor) anchors.insert(i.needle);
    if (i.op == Op::drop) anchors.erase(i.needle);
    if (i.op == Op::xfer) {
      EXPECT_TRUE(anchors.empty());
    }
  }
}

TEST(EmitProgram, LoopsAreMadeAtRackingZero) {
  const Program program = emit(knit_one_sided_cone(20, 10));
  double racking = 0.0;
  for (const Instruction& i : program.instructions) {
    if (i.op == Op::rack) racking = i.racking;
    if (i.op == Op::knit || i.op == Op::tuck) {
      EXPECT_EQ(racking, 0.0);
    }
    if (i.op == Op::xfer) {
      EXPECT_EQ(racking_between(i.needle, i.target), racking);
    }
  }
}

TEST(EmitProgram, AnIncreaseIsAKnitAndATuckBackwardsOnTheNextNeedle) {
  TubeKnitter tube(24);
  tube.round().increase().knit(5).increase().knit(5).increase().knit(5).increase().knit(5);
  const StitchTrace trace = tube.end();
  const Program program = emit(trace);
  int inside_a_bed = 0;
  for (size_t i = 0; i + 1 < program.instructions.size(); ++i) {
    const Instruction& knit = program.instructions[i];
    const Instruction& tuck = program.instructions[i + 1];
    if (knit.op != Op::knit || knit.source.kind != Source::Kind::stitch ||
        trace.stitches[knit.source.stitch].kind != StitchKind::increase)
      continue;
    EXPECT_EQ(tuck.op, Op::tuck);
    EXPECT_EQ(tuck.source.stitch, knit.source.stitch);
    if (tuck.needle.bed != knit.needle.bed) continue;
    ++inside_a_bed;
    // Half gauge: the next place is two needles on, ahead in the direction of the knit.
    EXPECT_EQ(tuck.needle.index - knit.needle.index, knit.direction == Side::right ? 2 : -2);
    EXPECT_NE(tuck.direction, knit.direction);
  }
  // Four increases, of which at most one can lie round each end of the tube.
  EXPECT_GE(inside_a_bed, 2);
}

TEST(EmitProgram, AMoveThatNoPlanMakesNamesItsStitches) {
  const StitchTrace trace = knit_plain_tube(8, 4);
  Schedule schedule = schedule_stitches(trace, shima());
  // Torn apart by hand: the front bed's loops are to hang far away from the back bed's.
  for (Hook& hook : schedule.steps[2].moved_hooks) hook.n += hook.bed == Bed::front ? 30 : -30;
  MachineProfile stiff = shima();
  stiff.max_racking = 0;
  try {
    emit_program(trace, schedule, stiff);
    FAIL();
  } catch (const NotKnittable& refused) {
    const Problem* problem = find_problem(refused.problems(), "transfer-impossible");
    ASSERT_NE(problem, nullptr);
    EXPECT_FALSE(problem->elements.stitches.empty());
  }
}

TEST(EmitProgram, CancellingStopsIt) {
  const StitchTrace trace = knit_plain_tube(8, 4);
  const Schedule schedule = schedule_stitches(trace, shima());
  RunContext run;
  run.cancel();
  EXPECT_THROW(emit_program(trace, schedule, shima(), &run), Cancelled);
}

}  // namespace
}  // namespace meshknit
