#include "meshknit/verify/yarn_slack.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cstdint>

namespace meshknit {
namespace {

// Loops of one yarn, made one after another.
class YarnSlackTest : public ::testing::Test {
 protected:
  int make(Bed bed, int index, int racking = 0) {
    const int id = static_cast<int>(fabric.loops.size());
    Loop loop;
    loop.made_on = loop.hangs_on = {bed, index, false};
    loop.previous = id - 1;
    if (id > 0) fabric.loops[id - 1].following = id;
    fabric.loops.push_back(loop);
    slack.made(id, racking);
    return id;
  }

  void move(int loop, Bed bed, int index, int racking = 0) {
    fabric.loops[loop].hangs_on = {bed, index, false};
    slack.moved(loop, racking, 1);
  }

  void let_go(int loop) {
    fabric.loops[loop].fate = Loop::Fate::dropped;
    slack.let_go(loop);
  }

  MachineProfile profile = machine_profile("shima_swg091n2");  // max_stretch 5, max_float 7
  Fabric fabric;
  ProblemLog log;
  YarnSlack slack{fabric, profile, log};
};

TEST_F(YarnSlackTest, RackingStretchesTheYarnBetweenTheBeds) {
  make(Bed::front, 10);
  make(Bed::back, 11);
  slack.racked(4 * kQuarters, 1);  // b11 stands at 15
  EXPECT_EQ(log.errors(), 0);
  EXPECT_EQ(fabric.max_stretch, 5 * kQuarters);
  slack.racked(4 * kQuarters + 1, 2);  // a quarter needle too far
  EXPECT_EQ(log.errors(), 1);
}

TEST_F(YarnSlackTest, RackingLeavesYarnOnOneBedAlone) {
  make(Bed::back, 10);
  make(Bed::back, 15);
  slack.racked(40 * kQuarters, 1);
  EXPECT_EQ(log.errors(), 0);
}

TEST_F(YarnSlackTest, YarnThatWasMadeLongMayStayLong) {
  make(Bed::front, 10);
  const int far = make(Bed::front, 17);
  EXPECT_EQ(log.errors(), 0);
  move(far, Bed::back, 17);
  EXPECT_EQ(log.errors(), 0);
  move(far, Bed::back, 18);
  EXPECT_EQ(log.errors(), 1);
}

TEST_F(YarnSlackTest, ALoopThatWasLetGoPullsNoMore) {
  const int first = make(Bed::front, 10);
  make(Bed::back, 11);
  let_go(first);
  slack.racked(20 * kQuarters, 1);
  EXPECT_EQ(log.errors(), 0);
}

TEST_F(YarnSlackTest, EveryBridgeIsSeenAtEveryRacking) {
  std::uint64_t state = 3;
  const auto below = [&](int n) {
    state = state * 6364136223846793005ULL + 1442695040888963407ULL;
    return static_cast<int>((state >> 33) % static_cast<std::uint64_t>(n));
  };
  const auto bed = [&] { return below(2) == 0 ? Bed::front : Bed::back; };
  for (int step = 0; step < 5000; ++step) {
    const int count = static_cast<int>(fabric.loops.size());
    const int loop = count > 0 ? below(count) : 0;
    const bool held = count > 0 && fabric.loops[loop].fate == Loop::Fate::held;
    switch (below(4)) {
      case 0:
        make(bed(), below(20));
        break;
      case 1:
        if (held) move(loop, bed(), below(20));
        break;
      case 2:
        if (held && below(3) == 0) let_go(loop);
        break;
      default:
        const int racking = below(33) - 16;
        int expected = log.errors();
        for (const Loop& second : fabric.loops) {
          if (second.previous < 0) continue;
          const Loop& first = fabric.loops[second.previous];
          const bool bridges = first.fate == Loop::Fate::held &&
                               second.fate == Loop::Fate::held &&
                               first.hangs_on.bed != second.hangs_on.bed;
          const int allowed = std::max(kQuarters * profile.max_stretch, second.made_distance);
          if (bridges && needle_distance(first.hangs_on, second.hangs_on, racking) > allowed) {
            ++expected;
          }
        }
        slack.racked(racking, 1);
        ASSERT_EQ(log.errors(), expected);
    }
  }
}

}  // namespace
}  // namespace meshknit
