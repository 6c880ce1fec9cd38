#include "meshknit/schedule/schedule.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cstdlib>
#include <string>
#include <utility>

#include "meshknit/core/error.h"
#include "meshknit/emit/step_transfers.h"
#include "meshknit/schedule/schedule_checks.h"
#include "schedule/tube_knitter.h"

namespace meshknit {
namespace {

MachineProfile half_metre_machine() {
  MachineProfile profile;
  profile.needles = 300;
  return profile;
}

std::string first_message(const Problems& problems) {
  return problems.empty() ? "" : problems.front().message;
}

bool moves(const ScheduleStep& step) {
  for (size_t i = 0; i < step.before.size(); ++i)
    if (!(step.before_hooks[i] == step.moved_hooks[i])) return true;
  return false;
}

TEST(Schedule, APlainTubeNeverMovesALoop) {
  for (const int loops : {2, 3, 6, 7, 60, 61}) {
    const StitchTrace trace = knit_plain_tube(loops, 10);
    const Schedule schedule = schedule_stitches(trace, half_metre_machine());
    EXPECT_EQ(first_message(check_schedule(trace, schedule, half_metre_machine())), "");
    EXPECT_EQ(schedule.steps.size(), 10u) << "a step is a round";
    // An odd tube has one loop more on one bed, in every round.
    EXPECT_EQ(schedule.cost.alignment, loops % 2 == 0 ? 0 : 10);
    EXPECT_EQ(schedule.cost.roll, 0);
    EXPECT_EQ(schedule.cost.shift, 0);
    for (const ScheduleStep& step : schedule.steps) EXPECT_FALSE(moves(step));
  }
}

TEST(Schedule, AShortRowNeedsNoTransfer) {
  TubeKnitter tube(20);
  tube.round().knit(9).turn().knit(6).turn().knit(6).round();
  const StitchTrace trace = tube.end();
  const Schedule schedule = schedule_stitches(trace, half_metre_machine());
  EXPECT_EQ(first_message(check_schedule(trace, schedule, half_metre_machine())), "");
  for (const ScheduleStep& step : schedule.steps) EXPECT_FALSE(moves(step));
  // The first tuck is made before the turn, with the stitches that lead to it.
  for (const ScheduleStep& step : schedule.steps)
    for (int s = step.first_stitch; s <= step.last_stitch; ++s)
      EXPECT_EQ(trace.stitches[s].direction, trace.stitches[step.first_stitch].direction);
}

// Carriage passes of all transfers.
int passes_of(const StitchTrace& trace, const Schedule& schedule) {
  TransferPlanner planner;
  int passes = 0;
  for (const ScheduleStep& step : schedule.steps)
    passes += count_passes(plan_step_transfers(step, transfer_direction(trace, step),
                                               half_metre_machine(), planner));
  return passes;
}

// Two decreases opposite each other, on a rotation that puts one on each bed, keep both beds
// equally long: one pass lifts loops of the front, the next puts them down and lifts those of the
// back, the third puts these down. Four such rounds.
TEST(Schedule, DecreasesOnOppositeSidesTakeThreePassesARound) {
  TubeKnitter tube(24);
  for (int r = 0; r < 4; ++r) {
    const int half = tube.loops() / 2;
    tube.decrease().knit(half - 2).decrease().knit(half - 2);
    tube.round();
  }
  const StitchTrace trace = tube.end();
  const Schedule schedule = schedule_stitches(trace, half_metre_machine());
  EXPECT_EQ(first_message(check_schedule(trace, schedule, half_metre_machine())), "");
  EXPECT_LE(passes_of(trace, schedule), 4 * 3);
}

// A cone that loses one loop a round from 24 down to 8, always at the same spot. A decrease takes
// two passes. Every two rounds one bed would be two loops short, so one loop must come round from
// the other bed, which takes one pass more: 16 decreases, 8 rolls.
TEST(Schedule, OneSidedShapingTakesFivePassesForTwoDecreases) {
  const StitchTrace trace = knit_one_sided_cone(24, 8);
  const Schedule schedule = schedule_stitches(trace, half_metre_machine());
  EXPECT_EQ(first_message(check_schedule(trace, schedule, half_metre_machine())), "");
  EXPECT_LE(passes_of(trace, schedule), 8 * 5);
}

// Two decreases on one side, then two on the other: the balance of the beds may be off by one until
// the other side has its turn, so none takes more than its own two passes.
TEST(Schedule, ABalanceThatComesBackByItselfIsNotRestored) {
  TubeKnitter tube(24);
  for (int side = 0; side < 2; ++side)
    for (int r = 0; r < 2; ++r) {
      const int before = side == 0 ? 4 : tube.loops() / 2 + 4;
      tube.knit(before).decrease().knit(tube.loops() - before - 2);
      tube.round();
    }
  const StitchTrace trace = tube.end();
  const Schedule schedule = schedule_stitches(trace, half_metre_machine());
  EXPECT_EQ(first_message(check_schedule(trace, schedule, half_metre_machine())), "");
  EXPECT_LE(passes_of(trace, schedule), 4 * 2);
}

TEST(Schedule, RandomTubesKeepEveryPromise) {
  for (std::uint32_t seed = 0; seed < 200; ++seed) {
    const StitchTrace trace = knit_random_tube(seed, 6 + static_cast<int>(seed % 31), 8, 6);
    const Schedule schedule = schedule_stitches(trace, half_metre_machine());
    ASSERT_EQ(first_message(check_schedule(trace, schedule, half_metre_machine())), "")
        << "seed " << seed;
  }
}

TEST(Schedule, NeighboursNeverHangMoreThanTwoPlacesApart) {
  for (std::uint32_t seed = 0; seed < 100; ++seed) {
    const StitchTrace trace = knit_random_tube(seed, 16, 8, 4);
    const Schedule schedule = schedule_stitches(trace, half_metre_machine());
    for (const ScheduleStep& step : schedule.steps)
      for (size_t i = 0; i < step.moved_hooks.size(); ++i) {
        const Hook &a = step.moved_hooks[i],
                   &b = step.moved_hooks[(i + 1) % step.moved_hooks.size()];
        ASSERT_LE(std::abs(a.n - b.n), 2) << "seed " << seed;
      }
  }
}

TEST(Schedule, TheTubeStaysInTheMiddleOfTheBed) {
  const Schedule schedule = schedule_stitches(knit_plain_tube(20, 4), half_metre_machine());
  int lowest = 1000, highest = 0;
  for (const Hook& hook : schedule.ends[0].hooks) {
    lowest = std::min(lowest, hook.n);
    highest = std::max(highest, hook.n);
  }
  // Places 1..149 are free: as many left of the tube as right of it, but for one.
  EXPECT_LE(std::abs((lowest - 1) - (149 - highest)), 1);
}

TEST(Schedule, ATubeWiderThanTheBedSaysWhichScaleFits) {
  MachineProfile small;
  small.needles = 60;
  // Places 1..29, four of them kept free at each end: 21 places, 42 loops. 60 loops need 30
  // places; 21/30 = 70 %.
  try {
    schedule_stitches(knit_plain_tube(60, 4), small);
    FAIL() << "60 loops cannot hang on 21 places";
  } catch (const NotKnittable& refused) {
    const Problem* problem = find_problem(refused.problems(), "too-wide");
    ASSERT_NE(problem, nullptr);
    EXPECT_NE(problem->remedy.find("70 %"), std::string::npos) << problem->remedy;
    EXPECT_EQ(problem->elements.nodes.size(), 60u);
  }
  EXPECT_NO_THROW(schedule_stitches(knit_plain_tube(42, 4), small));
}

// On both beds a decrease near the left end and an increase near the right end, every round: the
// tube leans to the right, but on a narrow bed cannot hang further and further there.
TEST(Schedule, ALeaningTubeStaysOnTheBed) {
  TubeKnitter tube(28);
  for (int r = 0; r < 12; ++r) {
    tube.knit(3).decrease().knit(18).decrease().knit(3);
    tube.knit(9).increase().knit(6).increase().knit(9);
  }
  const StitchTrace trace = tube.end();
  const Schedule walking = schedule_stitches(trace, half_metre_machine());
  EXPECT_TRUE(walking.optimal());
  EXPECT_EQ(walking.cost.roll, 0);

  MachineProfile small;
  small.needles =
      46;  // places 1..22, four kept free at each end: just the 14 that 28 loops need
  const Schedule kept = schedule_stitches(trace, small);
  EXPECT_EQ(first_message(check_schedule(trace, kept, small)), "");
  EXPECT_FALSE(kept.optimal()) << "loops had to move that could have stayed on a wider bed";
  EXPECT_EQ(kept.cost.roll, 0);
}

// Three short rows over the same stitches: each tucks on the loop beyond its ends, which then
// carries 1 + 3 loops.
TEST(Schedule, ShortRowsThatEndOnTopOfEachOtherAreRefused) {
  TubeKnitter tube(20);
  tube.round().knit(10);
  for (int i = 0; i < 3; ++i) tube.turn().knit(6).turn().knit(6);
  try {
    schedule_stitches(tube.knit(4).end(), half_metre_machine());
    FAIL() << "no needle holds four loops";
  } catch (const NotKnittable& refused) {
    const Problem* problem = find_problem(refused.problems(), "stack-too-high");
    ASSERT_NE(problem, nullptr);
    EXPECT_NE(problem->message.find("4 loops"), std::string::npos) << problem->message;
    // One loop at each end of the short rows.
    EXPECT_EQ(problem->elements.nodes.size(), 2u);
  }
}

TEST(Schedule, ParentsThatDoNotHangSideBySideAreRefused) {
  StitchTrace trace = knit_plain_tube(8, 4);
  std::swap(trace.stitches[9].parents, trace.stitches[12].parents);
  trace.stitches[8].parents = {0, 4};
  EXPECT_THROW(schedule_stitches(trace, half_metre_machine()), NotKnittable);
}

TEST(Schedule, CancellingStopsIt) {
  RunContext run;
  run.cancel();
  EXPECT_THROW(schedule_stitches(knit_one_sided_cone(24, 8), half_metre_machine(), &run),
               Cancelled);
}

class BrokenSchedule : public testing::Test {
 protected:
  void expect(const std::string& code) {
    EXPECT_NE(find_problem(check_schedule(trace, schedule, half_metre_machine()), code),
              nullptr);
  }
  StitchTrace trace = knit_random_tube(5, 14, 6, 4);
  Schedule schedule = schedule_stitches(trace, half_metre_machine());
};

TEST_F(BrokenSchedule, AForgottenStepIsFound) {
  schedule.steps.pop_back();
  expect("step-order");
}
TEST_F(BrokenSchedule, ALoopThatJumpedBetweenStepsIsFound) {
  schedule.steps[2].before_hooks[0].n += 1;
  expect("step-start");
}
TEST_F(BrokenSchedule, AStitchOnAnotherNeedleIsFound) {
  std::swap(schedule.steps[1].stitch_hooks[0], schedule.steps[1].stitch_hooks[3]);
  expect("wrong-parents");
}
TEST_F(BrokenSchedule, ATubeTornApartIsFound) {
  for (ScheduleStep& step : schedule.steps)
    for (std::vector<Hook>* hooks :
         {&step.before_hooks, &step.moved_hooks, &step.stitch_hooks, &step.second_loop_hooks})
      for (Hook& hook : *hooks) hook.n += hook.bed == Bed::back ? 2 : 0;
  expect("no-layout");
}
TEST_F(BrokenSchedule, NeedlesBeyondTheBedAreFound) {
  for (ScheduleStep& step : schedule.steps)
    for (std::vector<Hook>* hooks :
         {&step.before_hooks, &step.moved_hooks, &step.stitch_hooks, &step.second_loop_hooks})
      for (Hook& hook : *hooks) hook.n += 100;
  expect("off-bed");
}
TEST_F(BrokenSchedule, AnIncreaseOntoAnotherLoopIsFound) {
  for (ScheduleStep& step : schedule.steps)
    for (int s = step.first_stitch; s <= step.last_stitch; ++s)
      if (trace.stitches[s].kind == StitchKind::increase)
        step.second_loop_hooks[s - step.first_stitch] =
            step.moved_hooks[step.moved_hooks.size() / 2];
  expect("hook-taken");
}

}  // namespace
}  // namespace meshknit
