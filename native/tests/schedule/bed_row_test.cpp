#include "meshknit/schedule/bed_row.h"

#include <gtest/gtest.h>

#include <algorithm>

namespace meshknit {
namespace {

/// As many loops on the front bed as on the back, above each other.
BedLayout flat(int columns, int place) { return {2 * columns, 0, {columns, 0}, place}; }

int places_free(const BedRow& bed, int left, int right) {
  return places_between(bed.layout(left), bed.layout(right));
}

/// Follows all moves of two tubes: the most places that were ever free between them.
int farthest_apart(BedRow& bed, int left, BedLayout left_layout, int right,
                   BedLayout right_layout) {
  int most = places_between(left_layout, right_layout);
  for (const PlacedStep& step : bed.take_steps()) {
    if (step.tube == left) left_layout = step.after;
    if (step.tube == right) right_layout = step.after;
    most = std::max(most, places_between(left_layout, right_layout));
  }
  return most;
}

// Two places to give a leg room beside it, where the two legs beyond have just parted: the yarn
// between those bears one place.
TEST(BedRow, LegsThatHaveJustPartedGiveWayPlaceByPlace) {
  const BedLayout grown = flat(6, 0), left = flat(3, 5), right = flat(3, 8);
  BedRow bed(3, {0, 30});
  bed.set_order({0, 1, 2});
  bed.hang(0, flat(4, 0));
  bed.hang(1, left);
  bed.hang(2, right);
  bed.make_room(0, grown);
  const OffsetChoice free = bed.free_offsets(0, grown);
  EXPECT_LE(free.lowest, 0);
  EXPECT_GE(free.highest, 0);
  EXPECT_EQ(places_free(bed, 1, 2), 0) << "they still touch";
  EXPECT_LE(farthest_apart(bed, 1, left, 2, right), 1);
}

// The middle one of three that have just parted needs a place on both sides. Where one of its
// neighbours hangs at the wall, the other one must go two places, and it goes after.
TEST(BedRow, TheMiddleOfThreeAtTheWallGoesAfterItsNeighbour) {
  for (const bool wall_right : {true, false}) {
    const int at = wall_right ? 21 : 0;
    const BedLayout left = flat(3, at), middle = flat(3, at + 3), right = flat(3, at + 6);
    for (const bool watch_left : {true, false}) {
      BedRow bed(3, {0, 29});
      bed.set_order({0, 1, 2});
      bed.hang(0, left);
      bed.hang(1, middle);
      bed.hang(2, right);
      bed.make_room(1, middle);
      BedLayout moved = middle;
      moved.place = bed.layout(1).place;
      const OffsetChoice free = bed.free_offsets(1, moved);
      EXPECT_LE(free.lowest, 0);
      EXPECT_GE(free.highest, 0);
      bed.knit(1, 0, moved);
      EXPECT_EQ(places_free(bed, 0, 1), kFreeBetween);
      EXPECT_EQ(places_free(bed, 1, 2), kFreeBetween);
      EXPECT_LE(watch_left ? farthest_apart(bed, 0, left, 1, middle)
                           : farthest_apart(bed, 1, middle, 2, right),
                1)
          << (wall_right ? "right" : "left") << " wall";
    }
  }
}

}  // namespace
}  // namespace meshknit
