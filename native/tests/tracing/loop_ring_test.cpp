#include "meshknit/tracing/loop_ring.h"

#include <gtest/gtest.h>

namespace meshknit {
namespace {

/// The ring of a loop, anticlockwise from it, checked against the way back.
std::vector<int> round_from(const LoopRing& ring, int first) {
  std::vector<int> loops{first};
  for (int loop = ring.next(first); loop != first; loop = ring.next(loop)) {
    EXPECT_EQ(ring.previous(loop), loops.back());
    loops.push_back(loop);
  }
  EXPECT_EQ(ring.previous(first), loops.back());
  return loops;
}

LoopRing ring_of(int n) {
  LoopRing ring;
  int last = ring.add_alone();
  while (last + 1 < n) last = ring.add_after(last);
  return ring;
}

TEST(LoopRing, ATubeHangsInARing) {
  EXPECT_EQ(round_from(ring_of(4), 0), (std::vector<int>{0, 1, 2, 3}));
  EXPECT_EQ(round_from(ring_of(1), 0), (std::vector<int>{0}));
}

TEST(LoopRing, ANewLoopTakesThePlaceOfTheOneItIsKnitThrough) {
  LoopRing ring = ring_of(3);
  const int loop = ring.add_after(1);
  ring.take_off(1);
  EXPECT_FALSE(ring.hangs(1));
  EXPECT_EQ(round_from(ring, 0), (std::vector<int>{0, loop, 2}));
}

TEST(LoopRing, ATubePartsAndMeetsAgain) {
  LoopRing ring = ring_of(6);
  ring.join({0, 1, 4});
  EXPECT_EQ(round_from(ring, 0), (std::vector<int>{0, 1, 4}));
  EXPECT_EQ(round_from(ring, 2), (std::vector<int>{2, 3, 5})) << "the others stay a tube";
  ring.join({4, 0, 1, 2, 3, 5});
  EXPECT_EQ(round_from(ring, 0), (std::vector<int>{0, 1, 2, 3, 5, 4}));
}

}  // namespace
}  // namespace meshknit
