#include "meshknit/schedule/needle_offsets.h"

#include <gtest/gtest.h>

#include <algorithm>

#include "graphs.h"
#include "meshknit/schedule/tube_layouts.h"
#include "meshknit/tracing/trace.h"

namespace meshknit {
namespace {

using Front = GraphDrawing::Front;

Front joined(Front a, const Front& b) {
  a.insert(a.end(), b.begin(), b.end());
  return a;
}

/// Three legs that start one after another: two of them, then one that meets the first of them;
/// then both meet the second.
KnitGraph three_starting_legs(int first, int second, int third) {
  GraphDrawing drawing;
  std::vector<Front> legs{drawing.cast_on(first), drawing.cast_on(second),
                          drawing.cast_on(third)};
  for (int row = 0; row < 3; ++row)
    for (Front& leg : legs) leg = drawing.closed_row(leg, links(static_cast<int>(leg.size())));
  const Front both = drawing.closed_row(joined(legs[0], legs[2]), links(first + third));
  legs[1] = drawing.closed_row(legs[1], links(second));
  drawing.closed_row(joined(both, legs[1]), links(first + second + third));
  return drawing.graph();
}

/// The order in which tubes that start hang up at these places in the row.
BedOrder order_with_starts_at(const SteppedTubes& tubes,
                              const std::vector<Connection>& connections,
                              const std::vector<int>& places) {
  BedOrder order;
  std::vector<int> held;
  std::size_t starts = 0;
  for (const SteppedTubes::Turn& turn : tubes.turns) {
    if (turn.step == 0 && tubes.tubes[turn.tube].below.empty())
      held.insert(held.begin() + places[starts++], turn.tube);
    for (const Connection& merge : connections) {
      if (turn.step > 0 || merge.whole != turn.tube) continue;
      const auto first =
          std::find_first_of(held.begin(), held.end(), merge.parts.begin(), merge.parts.end());
      order.left_part.push_back(*first == merge.parts[0] ? 0 : 1);
      *first = turn.tube;
      held.erase(first + 1);
    }
    order.held.push_back(held);
  }
  return order;
}

TEST(NeedleOffsets, RoomIsLeftForATubeThatStartsBetweenOthers) {
  for (const int third : {6, 7, 12}) {
    const StitchTrace trace = trace_knit_graph(three_starting_legs(8, 10, third));
    const SteppedTubes tubes = replay_tubes(trace);
    const std::vector<Connection> connections = find_connections(trace, tubes);
    const BedOrder order = order_with_starts_at(tubes, connections, {0, 1, 1});
    ASSERT_EQ(order.held[4].size(), 3u);
    MachineProfile machine;
    machine.needles = 400;
    const PlacedTubes placed =
        place_tubes(tubes, connections, order,
                    LayoutChoices(tubes, connections).layouts(order, false, nullptr), machine);
    // No leg moves before two of them meet; they hang a free place apart.
    const PlacedStep* merge = nullptr;
    for (const PlacedStep& step : placed.steps)
      if (!merge && step.step == 0 && !tubes.tubes[step.tube].below.empty()) merge = &step;
    int moves = 0;
    for (const PlacedStep* step = placed.steps.data(); step != merge; ++step)
      moves += step->before.place == step->after.place ? 0 : 1;
    EXPECT_EQ(moves, 1) << "one leg comes to the other, over a free place";
  }
}

}  // namespace
}  // namespace meshknit
