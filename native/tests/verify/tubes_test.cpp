#include "meshknit/verify/tubes.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cstdint>
#include <vector>

#include "meshknit/verify/tube_places.h"
#include "meshknit/verify/yarn_paths.h"

namespace meshknit {
namespace {

Needle front(int index) { return {Bed::front, index, false}; }
Needle back(int index) { return {Bed::back, index, false}; }

// A tube on these needles, which are in anticlockwise order. Returns its columns.
std::vector<int> hang(Tubes& tubes, const std::vector<Needle>& needles) {
  std::vector<int> columns = {tubes.begin(needles[0])};
  for (std::size_t k = 1; k < needles.size(); ++k) {
    columns.push_back(tubes.insert(tubes.tube_of(columns[0]), needles[k]));
  }
  return columns;
}

TEST(Tubes, SideBySideTheyAreClearAlsoAlongASlantingLine) {
  Tubes tubes;
  hang(tubes, {front(10), front(12), front(14), back(13), back(11)});
  hang(tubes, {front(16), front(18), back(19), back(17), back(15)});
  EXPECT_FALSE(tubes.tube_crosses(0, 1));
  EXPECT_EQ(tubes.side(0, 1), 1);
  EXPECT_EQ(tubes.side(1, 0), -1);
}

TEST(Tubes, OneWhollyOnOneBedMayLieOppositeAnother) {
  Tubes tubes;
  hang(tubes, {front(10), front(12), front(14), front(16), back(17)});
  hang(tubes, {back(15), back(13), back(11)});
  EXPECT_FALSE(tubes.tube_crosses(0, 1));
}

TEST(Tubes, ALoopAmongAnotherTubesIsNotClear) {
  Tubes tubes;
  const std::vector<int> left = hang(tubes, {front(10), front(12), back(13), back(11)});
  hang(tubes, {front(14), front(16), back(17), back(15)});
  tubes.move(left[1], back(16));
  EXPECT_TRUE(tubes.crosses(left[1], 1));
  EXPECT_TRUE(tubes.tube_crosses(0, 1));
  EXPECT_TRUE(tubes.tube_crosses(1, 0));
}

TEST(Tubes, TheyPartAndMeetAgainInTheSameOrder) {
  Tubes tubes;
  const std::vector<int> all = hang(tubes, {front(10), front(12), front(14), front(16),
                                            back(17), back(15), back(13), back(11)});
  // b13 becomes the neighbour of f12: f10 f12 b13 b11 part from f14 f16 b17 b15.
  const int parted = tubes.meet(all[1], all[6]);
  ASSERT_GE(parted, 0);
  EXPECT_EQ(tubes.tube_of(all[0]), tubes.tube_of(all[7]));
  EXPECT_EQ(tubes.tube_of(all[2]), parted);
  EXPECT_EQ(tubes.next(all[1]), all[6]);
  EXPECT_EQ(tubes.next(all[5]), all[2]);
  EXPECT_TRUE(tubes.order(parted).at_rest());
  EXPECT_EQ(tubes.meet(all[1], all[2]), -1);
  for (int k = 0; k < 8; ++k) EXPECT_EQ(tubes.next(all[k]), all[(k + 1) % 8]);
  EXPECT_EQ(tubes.held_tubes().size(), 1u);
}

TEST(Tubes, TubesThatMeetTurnedByALoopAreNotInOrder) {
  Tubes tubes;
  const std::vector<int> left = hang(tubes, {front(10), front(12), back(13), back(11)});
  const std::vector<int> right = hang(tubes, {front(14), front(16), back(17), back(15)});
  tubes.meet(left[0], right[0]);
  EXPECT_FALSE(tubes.order(tubes.tube_of(left[0])).at_rest());
}

// Clear means: no four columns a, b, a, b of two tubes follow one another round both beds.
TEST(Tubes, AgreesWithItsDefinitionAnywhere) {
  std::uint64_t state = 3;
  const auto below = [&](int n) {
    state = state * 6364136223846793005ULL + 1442695040888963407ULL;
    return static_cast<int>((state >> 33) % static_cast<std::uint64_t>(n));
  };
  int crossing = 0;
  for (int round = 0; round < 2000; ++round) {
    Tubes tubes;
    tubes.begin(front(100));
    tubes.begin(front(101));
    std::vector<int> owner(20, -1);  // front 0 to 9, then back 9 to 0
    for (int k = 0; k < 20; ++k) {
      owner[k] = below(3) - 1;
      if (owner[k] < 0) continue;
      tubes.insert(owner[k], k < 10 ? front(k) : back(19 - k));
    }
    tubes.remove(0);
    tubes.remove(1);
    std::vector<int> order;
    std::copy_if(owner.begin(), owner.end(), std::back_inserter(order),
                 [](int tube) { return tube >= 0; });
    int changes = 0;
    for (std::size_t k = 0; k < order.size(); ++k) {
      changes += order[k] != order[(k + 1) % order.size()];
    }
    ASSERT_EQ(tubes.tube_crosses(0, 1), changes > 2);
    ASSERT_EQ(tubes.tube_crosses(1, 0), changes > 2);
    crossing += changes > 2;
  }
  EXPECT_GT(crossing, 500);
  EXPECT_LT(crossing, 2000);
}

TEST(TubePlaces, ATubeMayNotComeBackOnTheOtherSide) {
  for (const bool returns : {true, false}) {
    Tubes tubes;
    ProblemLog log;
    TubePlaces places(tubes, log);
    const std::vector<int> left = hang(tubes, {front(10), back(11)});
    const std::vector<int> right = hang(tubes, {front(14), back(15)});
    places.touched(0);
    places.check(1);
    // The left one goes behind the right one, which is put on the front bed: nobody can tell.
    tubes.move(right[1], front(16));
    tubes.move(left[0], back(13));
    places.touched(0);
    places.check(2);
    EXPECT_EQ(log.errors(), 0);
    tubes.move(left[1], returns ? front(11) : front(20));
    places.touched(0);
    places.check(3);
    EXPECT_EQ(log.errors(), returns ? 0 : 1);
  }
}

TEST(YarnPaths, ACarrierThatWaitsInsideATubeIsWarnedOf) {
  Tubes tubes;
  ProblemLog log;
  // Two columns on the front bed, in a gap of a tube that is on both beds beside them.
  const std::vector<int> inner = hang(tubes, {front(20), front(22)});
  const std::vector<int> outer = hang(tubes, {front(18), front(24), back(25), back(17)});
  Fabric fabric;
  fabric.yarns.resize(2);
  const auto make = [&](int yarn, const Needle& needle) {
    Loop loop;
    loop.yarn = yarn;
    loop.line = static_cast<int>(fabric.loops.size()) + 1;
    loop.made_on = loop.hangs_on = needle;
    fabric.loops.push_back(loop);
  };
  make(0, front(20));
  make(1, front(18));
  YarnPaths paths(fabric, tubes, log);
  const std::vector<int> column_of = {inner[0], outer[0]};
  paths.made(0, column_of);
  EXPECT_EQ(log.warnings(), 0);
  paths.made(1, column_of);
  EXPECT_EQ(log.warnings(), 1);
  EXPECT_NE(find_problem(log.problems(), "carrier-inside-tube"), nullptr);
}

}  // namespace
}  // namespace meshknit
