#include "meshknit/tracing/tubes.h"

#include <gtest/gtest.h>

#include <set>

#include "branching_graphs.h"
#include "graphs.h"

namespace meshknit {
namespace {

TEST(Tubes, ATubeWithShortRowsIsOne) {
  EXPECT_EQ(find_tubes(plain_tube(8, 5)).count, 1);
  EXPECT_EQ(find_tubes(nested_short_rows()).count, 1);
}

TEST(Tubes, ATrunkAndItsLegsAreTubesOfTheirOwn) {
  EXPECT_EQ(find_tubes(splitting_tube(8)).count, 3);
  EXPECT_EQ(find_tubes(merging_tube(8)).count, 3);
  // A trunk, what is left of it when the first leg is off, three legs.
  EXPECT_EQ(find_tubes(three_legs(6, 6, 6, 3)).count, 5);
}

TEST(Tubes, AHoleLiesBetweenTwoTubes) {
  // Below it, left and right of it, above it.
  const Tubes tubes = find_tubes(tube_with_hole(6, 6, 4));
  EXPECT_EQ(tubes.count, 4);
  // Two rows below, four on each side, two above.
  const std::multiset<int> rows(tubes.of_row.begin(), tubes.of_row.end());
  for (const auto& [tube, expected] : {std::pair{0, 2u}, {1, 4u}, {2, 4u}, {3, 2u}})
    EXPECT_EQ(rows.count(tube), expected) << "tube " << tube;
}

TEST(Tubes, AShortRowBelongsToTheTubeThatItStandsOn) {
  GraphDrawing drawing;
  auto trunk = drawing.closed_row(drawing.cast_on(12), links(12));
  auto left = drawing.closed_row({trunk.begin(), trunk.begin() + 6}, links(6));
  drawing.closed_row({trunk.begin() + 6, trunk.end()}, links(6));
  left = drawing.short_row(left, 1, "|||");
  drawing.closed_row(left, links(6));
  const Tubes tubes = find_tubes(drawing.graph());
  // Rows: two of the trunk, left leg, right leg, short row on the left leg, left leg.
  EXPECT_EQ(tubes.of_row, (std::vector<int>{0, 0, 1, 2, 1, 1}));
}

}  // namespace
}  // namespace meshknit
