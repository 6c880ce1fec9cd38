// Schedules of objects whose tubes part and meet.

#include <gtest/gtest.h>

#include <algorithm>
#include <cstdlib>
#include <string>

#include "branching_graphs.h"
#include "graphs.h"
#include "meshknit/core/error.h"
#include "meshknit/schedule/schedule.h"
#include "meshknit/schedule/schedule_checks.h"
#include "meshknit/tracing/trace.h"

namespace meshknit {
namespace {

MachineProfile machine_of(int needles) {
  MachineProfile profile;
  profile.needles = needles;
  return profile;
}

std::string first_message(const Problems& problems) {
  return problems.empty() ? "" : problems.front().message;
}

Schedule schedule_cleanly(const StitchTrace& trace, int needles = 400) {
  const Schedule schedule = schedule_stitches(trace, machine_of(needles));
  EXPECT_EQ(first_message(check_schedule(trace, schedule, machine_of(needles))), "");
  return schedule;
}

/// Stacks that hang elsewhere after the transfers of a step.
int moved(const ScheduleStep& step) {
  int stacks = 0;
  for (std::size_t i = 0; i < step.before.size(); ++i)
    stacks += step.before_hooks[i] == step.moved_hooks[i] ? 0 : 1;
  return stacks;
}

bool knits(const ScheduleStep& step) { return step.last_stitch >= step.first_stitch; }

TEST(BranchesSchedule, TubesOfEverySizePartAndMeet) {
  for (int a = 3; a <= 9; ++a)
    for (int b = 3; b <= 9; ++b) {
      schedule_cleanly(trace_knit_graph(tube_with_hole(a, b, 3)));
      ASSERT_FALSE(HasFailure()) << a << " and " << b << " loops";
    }
}

// Where two even legs part each is half of the trunk's hooks: nothing rolls, and the leg that is
// knit first moves one place aside, once.
TEST(BranchesSchedule, OnlyOneLegMovesAsideOnce) {
  for (const int n : {4, 8, 20}) {
    const Schedule schedule = schedule_cleanly(trace_knit_graph(splitting_tube(n)));
    EXPECT_EQ(schedule.segments, 3);
    EXPECT_EQ(schedule.connections, 1);
    EXPECT_EQ(schedule.cost.alignment, 0);
    EXPECT_EQ(schedule.cost.roll, 0);
    EXPECT_EQ(schedule.cost.shift, n) << "one leg's loops";
    EXPECT_TRUE(schedule.optimal());
    int moves = 0;
    for (const ScheduleStep& step : schedule.steps) moves += moved(step) > 0 ? 1 : 0;
    EXPECT_EQ(moves, 1);
  }
}

TEST(BranchesSchedule, OneLegComesToTheOtherOnce) {
  for (const int n : {4, 8, 20}) {
    const Schedule schedule = schedule_cleanly(trace_knit_graph(merging_tube(n)));
    EXPECT_EQ(schedule.cost.roll, 0);
    EXPECT_EQ(schedule.cost.shift, n) << "one leg's loops";
    int moves = 0;
    for (const ScheduleStep& step : schedule.steps) {
      if (moved(step) == 0) continue;
      ++moves;
      EXPECT_FALSE(knits(step)) << "a whole tube moves between steps";
    }
    EXPECT_EQ(moves, 1);
  }
}

TEST(BranchesSchedule, TheLegsOfAPlainHoleHangStill) {
  // Parting moves one of them by a place, meeting moves one of them back.
  const Schedule schedule = schedule_cleanly(trace_knit_graph(tube_with_hole(8, 8, 6)));
  EXPECT_EQ(schedule.cost.roll, 0);
  EXPECT_EQ(schedule.cost.shift, 8 + 8);
}

TEST(BranchesSchedule, EveryLegEndsOnItsOwn) {
  const Schedule schedule = schedule_cleanly(trace_knit_graph(three_legs(6, 7, 8, 4)));
  ASSERT_EQ(schedule.ends.size(), 3u);
  std::vector<std::size_t> loops;
  for (const TubeEnd& end : schedule.ends) loops.push_back(end.loops.size());
  std::sort(loops.begin(), loops.end());
  EXPECT_EQ(loops, (std::vector<std::size_t>{6, 7, 8}));
}

// Legs that widen by two loops a row grow into each other: the outer ones must give way.
TEST(BranchesSchedule, WideningLegsPushTheirNeighboursAway) {
  const Schedule schedule = schedule_cleanly(trace_knit_graph(three_legs(8, 8, 8, 8, 2)));
  const bool pushed = std::any_of(schedule.steps.begin(), schedule.steps.end(),
                                  [](const ScheduleStep& step) { return !knits(step); });
  EXPECT_TRUE(pushed);
  EXPECT_FALSE(schedule.optimal());
}

TEST(BranchesSchedule, NarrowingLegsStayWhereTheyAre) {
  const Schedule schedule = schedule_cleanly(trace_knit_graph(three_legs(16, 16, 16, 6, -2)));
  for (const ScheduleStep& step : schedule.steps) EXPECT_TRUE(knits(step));
}

TEST(BranchesSchedule, LegsThatDoNotFitSideBySideAreNamedWithAScale) {
  // Two legs of 40 loops need 20 + 1 + 20 places. Of a bed of 90 needles the places 5..40 can be
  // used: 36, less the one between the legs 35. 35 of the 40 for the loops are 87 %.
  const StitchTrace trace = trace_knit_graph(splitting_tube(40));
  try {
    schedule_stitches(trace, machine_of(90));
    FAIL() << "the legs do not fit";
  } catch (const NotKnittable& refused) {
    const Problem* problem = find_problem(refused.problems(), "too-wide");
    ASSERT_NE(problem, nullptr);
    EXPECT_NE(problem->message.find("2 tubes"), std::string::npos) << problem->message;
    EXPECT_NE(problem->message.find("40 + 40"), std::string::npos) << problem->message;
    EXPECT_NE(problem->remedy.find("87 %"), std::string::npos) << problem->remedy;
    EXPECT_EQ(problem->elements.nodes.size(), 80u);
  }
  // 41 places: 5..45, so needles up to 2 * 49 + 1.
  EXPECT_NO_THROW(schedule_cleanly(trace, 100));
}

// Twelve needles are six places, and four at each end are kept free: no scale helps.
TEST(BranchesSchedule, WhereNoScaleFitsAWiderMachineIsAskedFor) {
  try {
    schedule_stitches(trace_knit_graph(splitting_tube(4)), machine_of(12));
    FAIL() << "nothing fits";
  } catch (const NotKnittable& refused) {
    const Problem* problem = find_problem(refused.problems(), "too-wide");
    ASSERT_NE(problem, nullptr);
    EXPECT_NE(problem->remedy.find("more needles"), std::string::npos) << problem->remedy;
  }
}

TEST(BranchesSchedule, PairsThatAreKnitOneAfterTheOtherDoNotCross) {
  schedule_cleanly(trace_knit_graph(crossed_pairs(4, 5, false)));
}

TEST(BranchesSchedule, PairsThatMustCrossAreRefused) {
  try {
    schedule_stitches(trace_knit_graph(crossed_pairs(4, 3, true)), machine_of(400));
    FAIL() << "two tubes meet behind two others that meet";
  } catch (const NotKnittable& refused) {
    const Problem* problem = find_problem(refused.problems(), "tubes-cross");
    ASSERT_NE(problem, nullptr);
    EXPECT_EQ(problem->elements.stitches.size(), 3u) << "two that would meet, one between";
    EXPECT_EQ(problem->elements.nodes.size(), 3u);
  }
}

class BrokenBranchSchedules : public testing::Test {
 protected:
  void expect(const std::string& code) {
    EXPECT_NE(find_problem(check_schedule(trace, schedule, machine_of(400)), code), nullptr)
        << first_message(check_schedule(trace, schedule, machine_of(400)));
  }
  void move_tube(int tube, int places) {
    for (ScheduleStep& step : schedule.steps) {
      if (step.tube != tube) continue;
      for (std::vector<Hook>* hooks :
           {&step.before_hooks, &step.moved_hooks, &step.stitch_hooks, &step.second_loop_hooks})
        for (Hook& hook : *hooks) hook.n += places;
    }
    for (TubeEnd& end : schedule.ends)
      for (Hook& hook : end.hooks) hook.n += end.tube == tube ? places : 0;
  }
  StitchTrace trace = trace_knit_graph(merging_tube(8));
  Schedule schedule = schedule_stitches(trace, machine_of(400));
};

TEST_F(BrokenBranchSchedules, ItIsGoodBeforeItIsBroken) {
  EXPECT_EQ(first_message(check_schedule(trace, schedule, machine_of(400))), "");
}
TEST_F(BrokenBranchSchedules, ATubeInTheRoomOfAnotherIsFound) {
  // The legs hang a place apart and are four places wide.
  move_tube(schedule.steps[0].tube, 1);
  expect("no-room");
}
TEST_F(BrokenBranchSchedules, LegsThatWereNotBroughtTogetherAreFound) {
  const auto moves = [](const ScheduleStep& step) { return !knits(step); };
  schedule.steps.erase(std::find_if(schedule.steps.begin(), schedule.steps.end(), moves));
  expect("step-start");
}
TEST_F(BrokenBranchSchedules, AStepOnAnotherTubeIsFound) {
  schedule.steps[0].tube = schedule.steps[2].tube;
  expect("step-form");
}
// Yarn that is said to be shorter than it is would let a racking tear it.
TEST_F(BrokenBranchSchedules, AWrongYarnBetweenTheBedsIsFound) {
  trace = trace_knit_graph(three_legs(7, 5, 9, 4, 2));
  schedule = schedule_stitches(trace, machine_of(400));
  int longer = 0;
  for (std::size_t i = 0; i < schedule.steps.size(); ++i) {
    const int bridge = schedule.steps[i].bridge_beside;
    longer += bridge > 1 ? 1 : 0;
    schedule.steps[i].bridge_beside = 4 - bridge;  // 1 for 3, 3 for 1
    expect("wrong-bridge");
    schedule.steps[i].bridge_beside = bridge;
  }
  EXPECT_GT(longer, 0) << "no step beside an odd leg whose back bed ends further right";
  EXPECT_EQ(first_message(check_schedule(trace, schedule, machine_of(400))), "");
}
TEST_F(BrokenBranchSchedules, ANeedleWithoutLoopsIsFound) {
  schedule.steps[0].before[0].clear();
  expect("step-form");
}
TEST_F(BrokenBranchSchedules, ATubeThatNeverEndsIsFound) {
  schedule.ends.clear();
  expect("step-start");
}

}  // namespace
}  // namespace meshknit
