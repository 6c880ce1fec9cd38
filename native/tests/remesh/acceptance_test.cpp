#include "meshknit/remesh/acceptance.h"

#include <gtest/gtest.h>

#include <utility>

namespace meshknit {
namespace {

using Runs = std::vector<std::pair<int, int>>;

// Nodes of time 0 come before the active time of 1, nodes of time 2 after it; each gains 0.1.
Runs accept(const std::vector<double>& times, int fewest = 3, int worthwhile = 3,
            double gain = 0.1) {
  Runs runs;
  const std::vector<double> gains(times.size(), gain);
  for (const NodeRun& run : accept_by_time(times, gains, 1.0, fewest, worthwhile))
    runs.push_back({run.first, run.last});
  return runs;
}

TEST(Acceptance, ARowThatIsWhollyLaterIsAWholeRow) {
  EXPECT_EQ(accept({2, 2, 2, 2, 2, 2, 2, 2}), Runs{});
}

TEST(Acceptance, ARowThatIsWhollyEarlierIsAWholeRow) {
  EXPECT_EQ(accept({0, 0, 0, 0, 0, 0, 0, 0}), Runs{});
}

TEST(Acceptance, TheEarlierPartBecomesAShortRow) {
  EXPECT_EQ(accept({2, 2, 0, 0, 0, 0, 2, 2, 2, 2}), (Runs{{2, 5}}));
  EXPECT_EQ(accept({2, 2, 1, 1, 1, 2, 2, 2, 2, 2}), (Runs{{2, 4}}))
      << "a node just at the active time belongs to it";
}

TEST(Acceptance, AShortRowMayPassTheRowsStart) {
  EXPECT_EQ(accept({0, 0, 2, 2, 2, 2, 2, 2, 0, 0}), (Runs{{8, 1}}));
}

TEST(Acceptance, APieceOfTwoNodesIsTooSmall) {
  EXPECT_EQ(accept({2, 0, 0, 2, 2, 2, 0, 0, 0, 2, 2, 2}), (Runs{{6, 8}}));
  EXPECT_EQ(accept({2, 0, 0, 2, 2, 2, 2, 2, 2, 2}), Runs{})
      << "with nothing left the whole row is knit";
}

TEST(Acceptance, AGapWithoutRoomForTwoTurnsIsClosed) {
  EXPECT_EQ(accept({2, 2, 2, 0, 0, 0, 2, 2, 0, 0, 0, 2, 2, 2}), (Runs{{3, 10}}));
  EXPECT_EQ(accept({2, 2, 2, 0, 0, 0, 2, 2, 2, 0, 0, 0, 2, 2, 2}), (Runs{{3, 5}, {9, 11}}));
}

TEST(Acceptance, ASmallPieceWaitsUntilItIsTwoRowsLate) {
  const std::vector<double> times = {2, 2, 2, 0.95, 0.95, 0.95, 0.95, 2, 2, 2, 2, 2};
  EXPECT_EQ(accept(times, 3, 6), Runs{}) << "one row late";
  EXPECT_EQ(accept(times, 3, 4), (Runs{{3, 6}})) << "long enough to be worth its turns";
  EXPECT_EQ(accept(times, 3, 6, 0.04), (Runs{{3, 6}})) << "0.95 + 0.04: two rows late";
}

}  // namespace
}  // namespace meshknit
