#include "meshknit/remesh/junction_links.h"

#include <gtest/gtest.h>

#include "surface/test_meshes.h"

namespace meshknit {
namespace {

double weight_of(const std::vector<double>& weights, const Stretch& stretch) {
  double sum = 0.0;
  for (int i = 0; i < stretch.count; ++i) sum += weights[(stretch.first + i) % weights.size()];
  return sum;
}

TEST(BestStretch, TakesWhatIsWantedInOnePiece) {
  const Stretch found = best_stretch({-1, -1, 2, 3, 1, -1, -1, -1}, 2);
  EXPECT_EQ(found.first, 2);
  EXPECT_EQ(found.count, 3);
}

TEST(BestStretch, GoesOnPastTheEndOfTheLoop) {
  const Stretch found = best_stretch({2, -1, -1, -1, -1, -1, 3, 1}, 2);
  EXPECT_EQ(found.first, 6);
  EXPECT_EQ(found.count, 3);
}

TEST(BestStretch, BridgesAGapOnlyIfItPays) {
  // 2 + 2 - 1 is more than 2; with -3 between them it is not.
  EXPECT_EQ(best_stretch({-5, 2, -1, 2, -5, -5}, 1).count, 3);
  EXPECT_EQ(best_stretch({-5, 2, -3, 2, -5, -5}, 1).count, 1);
}

TEST(BestStretch, LeavesEnoughOnBothSides) {
  EXPECT_EQ(best_stretch({1, 1, 1, 1, 1, 1, 1}, 2).count, 5);
  EXPECT_EQ(best_stretch({-1, -1, -1, -1, -1, -1, -1}, 3).count, 3);
}

TEST(BestStretch, IsBetterThanAllOthers) {
  Jitter jitter(7);
  for (int trial = 0; trial < 300; ++trial) {
    const int n = 4 + trial % 9, fewest = 1 + trial % 2;
    std::vector<double> weights;
    for (int i = 0; i < n; ++i) weights.push_back(jitter.next());
    const Stretch found = best_stretch(weights, fewest);
    EXPECT_GE(found.count, fewest);
    EXPECT_LE(found.count, n - fewest);
    for (int first = 0; first < n; ++first)
      for (int count = fewest; count <= n - fewest; ++count)
        EXPECT_GE(weight_of(weights, found) + 1e-8, weight_of(weights, {first, count}));
  }
}

}  // namespace
}  // namespace meshknit
