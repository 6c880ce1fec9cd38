#include <gtest/gtest.h>

#include <string>

#include "emit/knitted_program.h"
#include "graphs.h"
#include "meshknit/core/error.h"
#include "meshknit/emit/emit_program.h"
#include "meshknit/knitout/knitout_writer.h"
#include "meshknit/schedule/schedule_checks.h"
#include "meshknit/tracing/trace.h"
#include "meshknit/verify/verify_knitout.h"
#include "schedule/tube_knitter.h"

namespace meshknit {
namespace {

TEST(EndToEnd, PlainTubesOfEveryWidthKnitWithoutError) {
  for (int loops = 6; loops <= 60; ++loops)
    ASSERT_EQ(errors_of_program(knit_plain_tube(loops, 5)), "") << loops << " loops";
}

TEST(EndToEnd, TheLargestTubeOfTheMachineKnitsWithoutError) {
  // 540 needles a bed: places 1..269, four kept free at each end: 261 places a bed.
  EXPECT_EQ(errors_of_program(knit_plain_tube(522, 4)), "");
  EXPECT_THROW(schedule_stitches(knit_plain_tube(523, 4), shima()), NotKnittable);
}

TEST(EndToEnd, AConeThatLosesALoopAtOneSideEveryRoundKnitsWithoutError) {
  EXPECT_EQ(errors_of_program(knit_one_sided_cone(30, 6)), "");
}

TEST(EndToEnd, AConeThatGrowsAndShrinksAllRoundKnitsWithoutError) {
  TubeKnitter cone(24);
  for (int r = 0; r < 5; ++r) {
    for (int left = cone.loops(); left >= 6; left -= 6) cone.increase().knit(5);
    cone.round();
  }
  for (int r = 0; r < 5; ++r) {
    for (int left = cone.loops(); left >= 6; left -= 6) cone.decrease().knit(4);
    cone.round();
  }
  EXPECT_EQ(errors_of_program(cone.end()), "");
}

// The yarn goes back clockwise over a decrease: its first parent is the loop further on
// anticlockwise, and must lie below.
TEST(EndToEnd, ADecreaseOnTheWayBackStacksInTheYarnsOrder) {
  TubeKnitter tube(20);
  tube.round().knit(12).turn().knit(3).decrease().knit(3).turn().knit(7);
  EXPECT_EQ(errors_of_program(tube.end()), "");
}

TEST(EndToEnd, AnIncreaseOnTheWayBackLiesAheadOfItsStitch) {
  TubeKnitter tube(20);
  tube.round().knit(12).turn().knit(3).increase().knit(3).turn().knit(8);
  EXPECT_EQ(errors_of_program(tube.end()), "");
}

TEST(EndToEnd, ATuckMovesWithTheLoopThatItLiesOn) {
  TubeKnitter tube(20);
  tube.round().knit(10).turn().knit(6).turn().knit(6);
  // The first tuck lies on the next stack: it is decreased with the one after it.
  tube.decrease().knit(tube.loops() - 1);
  EXPECT_EQ(errors_of_program(tube.end()), "");
}

TEST(EndToEnd, HandKnitRandomTubesKnitWithoutError) {
  for (std::uint32_t seed = 0; seed < 60; ++seed)
    ASSERT_EQ(errors_of_program(knit_random_tube(seed, 6 + static_cast<int>(seed % 55), 8, 8)),
              "")
        << "seed " << seed;
}

// Some of these tubes have short rows that end on top of each other, which no needle holds:
// they are refused before a program is made. All others must come out right.
TEST(EndToEnd, RandomGraphsKnitWithoutError) {
  int knit = 0;
  for (std::uint64_t seed = 0; seed < 60; ++seed) {
    try {
      ASSERT_EQ(errors_of_program(trace_knit_graph(random_tube(seed))), "") << "seed " << seed;
      ++knit;
    } catch (const NotKnittable& refused) {
      ASSERT_EQ(refused.problems().front().code, "stack-too-high") << "seed " << seed;
    }
  }
  EXPECT_GE(knit, 30) << "most tubes can be knit";
}

TEST(EndToEnd, DrawnShortRowsKnitWithoutError) {
  for (const KnitGraph& graph :
       {one_short_row(), short_row_over_seam(), nested_short_rows(), short_row_with_increase(),
        stacked_short_rows(1), stacked_short_rows(2)})
    EXPECT_EQ(errors_of_program(trace_knit_graph(graph)), "");
}

TEST(EndToEnd, TheSameTraceGivesTheSameBytes) {
  const StitchTrace trace = knit_random_tube(7, 30, 8, 8);
  const auto text = [&] {
    return write_knitout(emit_program(trace, schedule_stitches(trace, shima()), shima()));
  };
  EXPECT_EQ(text(), text());
}

}  // namespace
}  // namespace meshknit
