#include "meshknit/remesh/side_by_side.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <limits>

#include "surface/test_meshes.h"

namespace meshknit {
namespace {

// A ring drawn with a letter for each element.
std::vector<int> ring(const std::string& letters) {
  std::vector<int> part;
  for (const char letter : letters) part.push_back(letter - 'A');
  return part;
}

std::string letters(const std::vector<PartStretch>& stretches, int n) {
  std::string drawn(n, '.');
  for (const PartStretch& stretch : stretches)
    for (int i = 0; i < stretch.count; ++i)
      drawn[(stretch.first + i) % n] = static_cast<char>('A' + stretch.part);
  return drawn;
}

std::string side_by_side_of(const std::string& drawn, int parts) {
  const std::vector<double> even(drawn.size(), 1.0);
  return letters(side_by_side(ring(drawn), even, parts, 2.0), static_cast<int>(drawn.size()));
}

TEST(SideBySide, MiddlePartsLieOnBothSides) {
  EXPECT_EQ(side_by_side_of("AAABBCCCCBB", 3), "AAABBCCCCBB");
  EXPECT_EQ(side_by_side_of("BBAAAABBCCDDDCC", 4), "BBAAAABBCCDDDCC");
}

TEST(SideBySide, AStrayStitchGoesToItsNeighbours) {
  EXPECT_EQ(side_by_side_of("AAACBBCCCCBB", 3), "AAAABBCCCCBB");
  EXPECT_EQ(side_by_side_of("AAABBCCBCCCBB", 3), "AAABBCCCCCCBB");
}

TEST(SideBySide, PartsRoundOneSpotDoNotHangSideBySide) {
  EXPECT_TRUE(side_by_side(ring("AAABBBCCC"), std::vector<double>(9, 1.0), 3, 2.0).empty());
}

TEST(SideBySide, APartThatIsNearestNowhereIsMissed) {
  EXPECT_TRUE(side_by_side(ring("AAABBBCBB"), std::vector<double>(9, 1.0), 3, 2.0).empty());
}

// Cost 1 for every element that goes to another part than drawn.
std::vector<std::vector<double>> cost_of(const std::string& drawn, int parts) {
  std::vector<std::vector<double>> cost(parts, std::vector<double>(drawn.size(), 1.0));
  for (std::size_t i = 0; i < drawn.size(); ++i) cost[drawn[i] - 'A'][i] = 0.0;
  return cost;
}

std::string balanced(const std::string& drawn, int parts, int fewest, int reach) {
  const std::vector<PartStretch> given =
      side_by_side(ring(drawn), std::vector<double>(drawn.size(), 1.0), parts, 1.0);
  return letters(balance(given, cost_of(drawn, parts), fewest, reach),
                 static_cast<int>(drawn.size()));
}

TEST(Balance, LeavesAlone) { EXPECT_EQ(balanced("AAAABBCCCCBB", 3, 4, 2), "AAAABBCCCCBB"); }

TEST(Balance, GivesAMiddlePartAsManyInFrontAsBehind) {
  // One of the four has to change sides; that both ends stay even takes a second one.
  const std::string drawn = "AAAABBBBCCCCBB", found = balanced(drawn, 3, 4, 3);
  const auto same = [&] {
    int count = 0;
    for (std::size_t i = 0; i < drawn.size(); ++i) count += drawn[i] == found[i];
    return count;
  };
  ASSERT_EQ(found.size(), drawn.size());
  EXPECT_EQ(std::count(found.begin(), found.begin() + 9, 'B'),
            std::count(found.begin() + 9, found.end(), 'B'));
  EXPECT_EQ(std::count(found.begin(), found.end(), 'A') % 2, 0);
  EXPECT_EQ(same(), 12);
}

TEST(Balance, SaysSoIfEndsWouldMoveTooFar) {
  const std::string drawn = "AAAABBBBBBBBBBBBCCCCBB";
  EXPECT_EQ(balanced(drawn, 3, 4, 2), std::string(drawn.size(), '.'));
}

// Every way to cut a ring into A B C B, by brute force.
double least_cost(const std::vector<std::vector<double>>& cost, int fewest) {
  const int n = static_cast<int>(cost.front().size());
  double least = std::numeric_limits<double>::infinity();
  for (int begin = 0; begin < n; ++begin)
    for (int a = fewest; a < n; ++a)
      for (int half = (fewest + 1) / 2; a + 2 * half + fewest <= n; ++half) {
        if (n % 2 == 0 && a % 2 != 0) continue;
        const int c = n - a - 2 * half;
        double sum = 0.0;
        for (int i = 0; i < n; ++i) {
          const int part = i < a ? 0 : i < a + half ? 1 : i < a + half + c ? 2 : 1;
          sum += cost[part][(begin + i) % n];
        }
        least = std::min(least, sum);
      }
  return least;
}

TEST(Balance, IsBetterThanAllOthers) {
  Jitter jitter(11);
  for (int trial = 0; trial < 60; ++trial) {
    const std::string drawn = "AAAAABBBCCCCCBB" + std::string(trial % 3, 'A');
    const int n = static_cast<int>(drawn.size());
    std::vector<std::vector<double>> cost = cost_of(drawn, 3);
    for (auto& of_part : cost)
      for (double& c : of_part) c = std::abs(c + 0.5 * jitter.next());
    const std::vector<PartStretch> given =
        side_by_side(ring(drawn), std::vector<double>(n, 1.0), 3, 1.0);
    const std::string found = letters(balance(given, cost, 4, n / 2), n);
    double sum = 0.0;
    for (int i = 0; i < n; ++i) sum += cost[found[i] - 'A'][i];
    EXPECT_NEAR(sum, least_cost(cost, 4), 1e-9) << drawn << " became " << found;
  }
}

}  // namespace
}  // namespace meshknit
