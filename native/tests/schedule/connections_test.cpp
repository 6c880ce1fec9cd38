#include "meshknit/schedule/connections.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cstdlib>
#include <set>
#include <utility>

#include "graphs.h"
#include "meshknit/core/error.h"
#include "meshknit/knit_graph/ring_parts.h"
#include "meshknit/tracing/trace.h"

namespace meshknit {
namespace {

/// A connection whose whole has x slots and then y, its parts numbered from some turn on.
Connection drawn(int x, int y, int turn) {
  Connection connection;
  connection.split = true;
  connection.whole = 0;
  connection.parts = {1, 2};
  connection.part_slots.resize(2);
  for (int i = 0; i < x + y; ++i) connection.whole_slots.push_back((i + turn) % (x + y));
  for (int i = 0; i < x; ++i) connection.part_slots[0].push_back((i + 2 * turn) % x);
  for (int i = 0; i < y; ++i) connection.part_slots[1].push_back((i + 3 * turn) % y);
  for (const int left : {0, -1})
    if (connection.ends.empty()) connection.ends = aligned_ends({x, y}, left);
  return connection;
}

bool is_allowed(const BedLayout& layout) {
  const std::vector<BedShape> shapes = bed_shapes(layout.slots);
  return std::any_of(shapes.begin(), shapes.end(), [&](const BedShape& shape) {
    return shape.front == layout.shape.front && shape.left == layout.shape.left;
  });
}

TEST(Connections, EveryLoopHangsOnOneHookInTheWholeAndInItsPart) {
  for (int x = 2; x <= 9; ++x)
    for (int y = 2; y <= 9; ++y)
      for (const int left : {0, 1})
        for (int turn = 0; turn < 3; ++turn) {
          const Connection connection = drawn(x, y, turn);
          const ConnectionLayout layout = connection_layout(connection, left);
          for (int i = 0; i < x + y; ++i) {
            const int part = i < x ? 0 : 1;
            const int slot = connection.part_slots[part][part == 0 ? i : i - x];
            ASSERT_EQ(slot_hook(layout.whole, connection.whole_slots[i]),
                      slot_hook(layout.parts[part], slot))
                << x << " and " << y << " loops, part " << left << " left";
          }
          ASSERT_EQ(places_between(layout.parts[left], layout.parts[1 - left]), 0)
              << "the parts touch";
        }
}

TEST(Connections, AllThreeTubesHaveLayoutsOfATubeAndEvenOnesAreAligned) {
  for (int x = 2; x <= 9; ++x)
    for (int y = 2; y <= 9; ++y)
      for (const int left : {0, 1}) {
        const ConnectionLayout layout = connection_layout(drawn(x, y, 1), left);
        for (const BedLayout& tube : {layout.whole, layout.parts[0], layout.parts[1]}) {
          ASSERT_TRUE(is_allowed(tube)) << x << " and " << y << " loops";
          ASSERT_TRUE(is_aligned(tube) || tube.slots % 2 != 0) << x << " and " << y;
          // The yarn from the front's end to the back's: b(2n+1) opposite f(2n), or b(2n-1). At
          // racking R it reaches |R + 1| or |R - 1| needles far, 5 at most for |R| <= 4.
          const int back_right = tube.shape.left + tube.slots - 2 * tube.shape.front;
          for (const int end : {tube.shape.left, back_right})
            ASSERT_TRUE(end == 0 || end == -1) << x << " and " << y;
        }
      }
}

TEST(Connections, ASplitGivesEveryLoopOfTheTrunkToOneLeg) {
  const StitchTrace trace = trace_knit_graph(splitting_tube(7));
  const SteppedTubes tubes = replay_tubes(trace);
  const std::vector<Connection> connections = find_connections(trace, tubes);
  ASSERT_EQ(connections.size(), 1u);
  EXPECT_TRUE(connections[0].split);
  std::vector<int> slots = connections[0].whole_slots;
  std::sort(slots.begin(), slots.end());
  for (int i = 0; i < 14; ++i) EXPECT_EQ(slots[i], i);
  EXPECT_EQ(connections[0].part_slots[0].size(), 7u);
  EXPECT_EQ(connections[0].part_slots[1].size(), 7u);
}

TEST(Connections, ThreeTubesThatPartAtOnceHangSideBySide) {
  const StitchTrace trace = trace_knit_graph(three_way_split(6, 3, 7, 3));
  const SteppedTubes tubes = replay_tubes(trace);
  const std::vector<Connection> connections = find_connections(trace, tubes);
  ASSERT_EQ(connections.size(), 1u);
  const Connection& connection = connections[0];
  ASSERT_EQ(connection.parts.size(), 3u);
  EXPECT_EQ(connection.part_slots[1].size(), 6u) << "3 + 3 loops between the others";
  for (const int left : {0, 1}) {
    const ConnectionLayout layout = connection_layout(connection, left);
    std::set<std::pair<bool, int>> whole, parts;
    const auto hook = [](const BedLayout& tube, int slot) {
      const Hook at = slot_hook(tube, slot);
      return std::make_pair(at.bed == Bed::front, at.n);
    };
    for (int slot = 0; slot < layout.whole.slots; ++slot)
      whole.insert(hook(layout.whole, slot));
    for (std::size_t part = 0; part < 3; ++part) {
      const BedLayout& own = layout.parts[part];
      ASSERT_TRUE(is_allowed(own));
      for (int slot = 0; slot < own.slots; ++slot) parts.insert(hook(own, slot));
      const int n = static_cast<int>(connection.part_slots[part].size());
      ASSERT_EQ(own.slots, n);
    }
    EXPECT_EQ(whole, parts);
    EXPECT_EQ(parts.size(), 19u) << "no hook holds loops of two tubes";
    const int leftmost = left == 0 ? 0 : 2;
    EXPECT_EQ(places_between(layout.parts[leftmost], layout.parts[1]), 0);
    EXPECT_EQ(places_between(layout.parts[1], layout.parts[2 - leftmost]), 0);
  }
}

TEST(Connections, AMiddleTubeWithMoreLoopsOnOneSideIsRefused) {
  try {
    const StitchTrace trace = trace_knit_graph(three_way_split(6, 2, 6, 6));
    find_connections(trace, replay_tubes(trace));
    FAIL() << "2 loops on one bed, 6 on the other";
  } catch (const NotKnittable& refused) {
    const Problem* problem = find_problem(refused.problems(), "tubes-not-side-by-side");
    ASSERT_NE(problem, nullptr);
    EXPECT_FALSE(problem->elements.nodes.empty());
  }
}

}  // namespace
}  // namespace meshknit
