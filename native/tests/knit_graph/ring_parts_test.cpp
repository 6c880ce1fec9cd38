#include "meshknit/knit_graph/ring_parts.h"

#include <gtest/gtest.h>

#include "meshknit/knit_graph/split_layout.h"

namespace meshknit {
namespace {

TEST(RingParts, TwoPartsAlwaysHangSideBySide) {
  const std::vector<PartStretch> found = ring_parts({7, 3, 3, 3, 7, 7});
  ASSERT_EQ(found.size(), 2u);
  EXPECT_EQ(found[0].part, 3);
  EXPECT_EQ(found[0].first, 1);
  EXPECT_EQ(found[0].count, 3);
  EXPECT_EQ(found[1].part, 7);
  EXPECT_EQ(found[1].count, 3);
}

TEST(RingParts, AMiddlePartIsNamedOnTheWayOutAndBack) {
  const std::vector<PartStretch> found = ring_parts({1, 1, 0, 2, 2, 0, 0});
  ASSERT_EQ(found.size(), 4u);
  EXPECT_EQ(found[0].part, 1);
  EXPECT_EQ(found[1].part, 0);
  EXPECT_EQ(found[2].part, 2);
  EXPECT_EQ(found[3].part, 0);
  EXPECT_EQ(found[3].count, 2);
}

TEST(RingParts, ThreePartsRoundOneSpotDoNot) {
  EXPECT_TRUE(ring_parts({0, 0, 1, 1, 2, 2}).empty());
  EXPECT_TRUE(ring_parts({0, 1, 0, 1}).empty());
  EXPECT_TRUE(ring_parts({4, 4, 4}).empty());
}

// What aligned_ends allows must be a common layout in the sense of Property 6.
TEST(AlignedEnds, AreLayoutsOfAllTubesAtOnce) {
  int fit = 0;
  for (int a = 4; a <= 7; ++a)
    for (int b = 4; b <= 7; ++b)
      for (int c = 4; c <= 7; ++c)
        for (const int left : {0, -1}) {
          const std::vector<int> ends = aligned_ends({a, b, c}, left);
          if (ends.empty()) continue;
          ++fit;
          // The middle tube's loops in front come before tube c's, those behind after them.
          const int in_front = (b - (ends[2] - ends[1])) / 2;
          std::vector<int> whole, middle, last;
          for (int i = 0; i < a + b + c; ++i) whole.push_back(i);
          const std::vector<int> first(whole.begin(), whole.begin() + a);
          for (int i = a; i < a + in_front; ++i) middle.push_back(i);
          for (int i = a + in_front; i < a + in_front + c; ++i) last.push_back(i);
          for (int i = a + in_front + c; i < a + b + c; ++i) middle.push_back(i);
          EXPECT_TRUE(has_common_layout({whole, first, middle, last}))
              << a << " " << b << " " << c;
        }
  EXPECT_GE(fit, 32);
}

TEST(AlignedEnds, EvenTubesAreAligned) {
  EXPECT_EQ(aligned_ends({6, 4, 8}, 0), (std::vector<int>{0, 0, 0, 0}));
  EXPECT_TRUE(aligned_ends({6, 4, 8}, -1).empty());
  // An odd tube needs another beside it, or the end of the bed.
  EXPECT_TRUE(aligned_ends({6, 5, 8}, 0).empty());
  EXPECT_EQ(aligned_ends({5, 5, 8}, 0), (std::vector<int>{0, -1, 0, 0}));
}

}  // namespace
}  // namespace meshknit
