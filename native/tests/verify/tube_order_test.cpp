#include "meshknit/verify/tube_order.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cstdint>
#include <map>

namespace meshknit {
namespace {

Needle front(int index) { return {Bed::front, index, false}; }
Needle back(int index) { return {Bed::back, index, false}; }

// f10 f12 f14 f16 and b17 b15 b13 b11: anticlockwise, columns 0 to 7, made in that order.
TubeOrder tube_of_eight() {
  TubeOrder tube;
  for (const int n : {10, 12, 14, 16}) tube.insert(front(n));
  for (const int n : {17, 15, 13, 11}) tube.insert(back(n));
  return tube;
}

TEST(TubeOrder, AFlatTubeIsAtRestHoweverItWasCastOn) {
  TubeOrder tube;
  // Every second needle of the round, then the others.
  for (const Needle& n :
       {front(16), front(12), back(11), back(15), front(14), front(10), back(13), back(17)}) {
    tube.insert(n);
    EXPECT_TRUE(tube.at_rest());
  }
  // f16's neighbours: b17 anticlockwise, f14 (the fifth made) clockwise.
  EXPECT_EQ(tube.next(0), 7);
  EXPECT_EQ(tube.previous(0), 4);
}

TEST(TubeOrder, AParkedLoopIsOutOfRestButNotPassedOver) {
  TubeOrder tube = tube_of_eight();
  tube.move(1, back(12));
  EXPECT_FALSE(tube.at_rest());
  EXPECT_LE(tube.turns(Bed::back), 2);
  tube.move(1, front(12));
  EXPECT_TRUE(tube.at_rest());
}

TEST(TubeOrder, TheWholeTubeCanBeCollapsedOntoOneBed) {
  TubeOrder tube = tube_of_eight();
  for (const int column : {0, 3, 1, 2}) {
    tube.move(column, back(10 + 2 * column));
    EXPECT_LE(tube.turns(Bed::back), 2);
  }
}

TEST(TubeOrder, ALoopAtTheEndMayRollToTheOtherBed) {
  TubeOrder tube = tube_of_eight();
  tube.move(3, back(19));
  EXPECT_TRUE(tube.at_rest());
  tube.move(2, back(21));
  EXPECT_TRUE(tube.at_rest());
}

TEST(TubeOrder, ALoopCannotBePutBeyondItsNeighbour) {
  TubeOrder tube = tube_of_eight();
  tube.move(1, back(12));
  tube.move(1, front(15));
  EXPECT_GT(tube.turns(Bed::front), 2);
}

// What the two questions mean, word for word, on a list and needle positions.
struct Plain {
  std::vector<int> list;  // anticlockwise
  std::map<int, Needle> at;

  static int key(const Needle& n) { return 2 * n.index + (n.slider ? 1 : 0); }
  bool at_rest() const {
    std::vector<int> reading = list;
    std::sort(reading.begin(), reading.end(), [&](int a, int b) {
      const Needle &x = at.at(a), &y = at.at(b);
      if (x.bed != y.bed) return x.bed == Bed::front;
      return x.bed == Bed::front ? key(x) < key(y) : key(x) > key(y);
    });
    if (list.empty()) return true;
    const auto first = std::find(reading.begin(), reading.end(), list.front());
    std::rotate(reading.begin(), first, reading.end());
    return reading == list;
  }
  int turns(Bed bed) const {
    std::vector<int> keys;
    for (const int c : list) {
      if (at.at(c).bed == bed) keys.push_back(key(at.at(c)));
    }
    const std::size_t n = keys.size();
    int count = 0;
    for (std::size_t k = 0; k < n; ++k) {
      const bool up = keys[(k + 1) % n] > keys[k];
      const bool came_up = keys[k] > keys[(k + n - 1) % n];
      if (up != came_up) ++count;
    }
    return count;
  }
};

TEST(TubeOrder, AgreesWithItsDefinitionAfterAnyMoves) {
  std::uint64_t state = 7;
  const auto below = [&](std::size_t n) {
    state = state * 6364136223846793005ULL + 1442695040888963407ULL;
    return static_cast<std::size_t>(state >> 33) % n;
  };
  for (int round = 0; round < 50; ++round) {
    TubeOrder tube;
    Plain plain;
    for (int step = 0; step < 200; ++step) {
      const Needle needle{below(2) == 0 ? Bed::front : Bed::back, static_cast<int>(below(12)),
                          below(4) == 0};
      const bool taken = std::any_of(plain.at.begin(), plain.at.end(),
                                     [&](const auto& entry) { return entry.second == needle; });
      const std::size_t choice = plain.list.size() < 3 ? 0 : below(6);
      if (choice == 0) {
        if (taken) continue;
        const int column = tube.insert(needle);
        plain.at[column] = needle;
        const int before = tube.previous(column);
        const auto place = std::find(plain.list.begin(), plain.list.end(), before);
        plain.list.insert(place == plain.list.end() ? place : place + 1, column);
      } else {
        const int column = plain.list[below(plain.list.size())];
        if (choice == 1) {
          tube.remove(column);
          plain.at.erase(column);
          plain.list.erase(std::find(plain.list.begin(), plain.list.end(), column));
        } else if (!taken) {
          tube.move(column, needle);
          plain.at[column] = needle;
        }
      }
      ASSERT_EQ(tube.at_rest(), plain.at_rest());
      ASSERT_EQ(tube.turns(Bed::front), plain.turns(Bed::front));
      ASSERT_EQ(tube.turns(Bed::back), plain.turns(Bed::back));
    }
  }
}

}  // namespace
}  // namespace meshknit
