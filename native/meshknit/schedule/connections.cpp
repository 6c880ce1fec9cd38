#include "meshknit/schedule/connections.h"

#include <algorithm>
#include <string>

#include "meshknit/core/error.h"

namespace meshknit {
namespace {

[[noreturn]] void refuse_torn(const StitchTrace& trace, const SteppedTubes& tubes, int part) {
  const int stitch = tubes.tubes[part].steps.front().first_stitch;
  Problem problem;
  problem.code = "loops-apart";
  problem.message = "Where tubes part or meet at stitch " + std::to_string(stitch) +
                    ", the loops of one tube do not hang side by side.";
  problem.remedy = "Change the knitting times there, or smooth the object.";
  problem.elements.stitches = {stitch};
  problem.elements.nodes = {trace.stitches[stitch].node};
  throw NotKnittable({problem});
}

// Two tubes become one, or one becomes two, and every loop goes on.
void require_pairs(const StitchTrace& trace, const SteppedTubes& tubes) {
  for (const TubeSteps& tube : tubes.tubes) {
    if (tube.below.empty()) continue;
    std::size_t given = 0, taken = 0;
    bool good = tube.below.size() <= 2;
    for (const int below : tube.below) {
      good = good && tubes.tubes[below].above.size() == 3 - tube.below.size();
      given += tubes.tubes[below].end.size();
    }
    for (const int beside : tubes.tubes[tube.below[0]].above)
      taken += tubes.tubes[beside].origins.size();
    if (good && given == taken) continue;
    const int stitch = tube.steps.front().first_stitch;
    Problem problem;
    problem.code = "tubes-not-in-pairs";
    problem.message = "At stitch " + std::to_string(stitch) +
                      " tubes part or meet otherwise than two and two.";
    problem.remedy =
        "Change the knitting times there, so that there is a row of stitches between one "
        "branch "
        "and the next.";
    problem.elements.stitches = {stitch};
    problem.elements.nodes = {trace.stitches[stitch].node};
    throw NotKnittable({problem});
  }
}

/// For each slot of the whole: which part, and the slot there.
struct PartSlot {
  int part = 0, slot = 0;
};

std::vector<PartSlot> part_slots_of(const SteppedTubes& tubes, const Connection& connection) {
  std::vector<PartSlot> slots;
  if (connection.split) {
    slots.resize(tubes.tubes[connection.whole].end.size());
    for (int part = 0; part < 2; ++part) {
      const std::vector<EndStack>& origins = tubes.tubes[connection.parts[part]].origins;
      for (int slot = 0; slot < static_cast<int>(origins.size()); ++slot)
        slots[origins[slot].stack] = {part, slot};
    }
  } else {
    for (const EndStack& origin : tubes.tubes[connection.whole].origins)
      slots.push_back({origin.tube == connection.parts[0] ? 0 : 1, origin.stack});
  }
  return slots;
}

// Each part must be one arc of the whole, in its own cyclic order.
bool is_arc(const std::vector<int>& part_slots) {
  const int n = static_cast<int>(part_slots.size());
  for (int i = 0; i + 1 < n; ++i)
    if (part_slots[i + 1] != (part_slots[i] + 1) % n) return false;
  return true;
}

void number_slots(const StitchTrace& trace, const SteppedTubes& tubes, Connection& connection) {
  const std::vector<PartSlot> slots = part_slots_of(tubes, connection);
  const int n = static_cast<int>(slots.size());
  int begin = 0;
  while (begin < n && !(slots[begin].part == 0 && slots[(begin + n - 1) % n].part == 1))
    ++begin;
  for (int i = 0; i < n; ++i) {
    const PartSlot& at = slots[(begin + i) % n];
    connection.whole_slots.push_back((begin + i) % n);
    connection.part_slots[at.part].push_back(at.slot);
    if (at.part == 0 && !connection.part_slots[1].empty())
      refuse_torn(trace, tubes, connection.parts[0]);
  }
  for (int part = 0; part < 2; ++part)
    if (!is_arc(connection.part_slots[part])) refuse_torn(trace, tubes, connection.parts[part]);
}

}  // namespace

std::vector<Connection> find_connections(const StitchTrace& trace, const SteppedTubes& tubes) {
  require_pairs(trace, tubes);
  std::vector<Connection> connections;
  for (const SteppedTubes::Turn& turn : tubes.turns) {
    const TubeSteps& tube = tubes.tubes[turn.tube];
    if (turn.step > 0 || tube.below.empty()) continue;
    Connection connection;
    connection.split = tube.below.size() == 1;
    connection.whole = connection.split ? tube.below[0] : turn.tube;
    const std::vector<int>& parts =
        connection.split ? tubes.tubes[tube.below[0]].above : tube.below;
    connection.parts = {parts[0], parts[1]};
    if (connection.split && turn.tube != parts[0]) continue;
    number_slots(trace, tubes, connection);
    connections.push_back(std::move(connection));
  }
  return connections;
}

ConnectionLayout connection_layout(const Connection& connection, int left) {
  const int right = 1 - left;
  const std::vector<int>&x = connection.part_slots[left], &y = connection.part_slots[right];
  const int nx = static_cast<int>(x.size()), ny = static_cast<int>(y.size());
  // How far the back bed's end lies right of the front bed's: at the left end, where the parts
  // meet, and at the right end. Odd cycles have one end that differs.
  const int left_end = nx % 2 != 0 && ny % 2 == 0 ? -1 : 0;
  const int meeting = nx % 2 != 0 && ny % 2 != 0 ? -1 : 0;
  const int right_end = ny % 2 != 0 && nx % 2 == 0 ? -1 : 0;
  const int x_back = (nx + meeting - left_end) / 2, x_front = nx - x_back;
  const int y_back = (ny + right_end - meeting) / 2, y_front = ny - y_back;

  // Round the whole, from the front's left end: x on the front, all of y, x on the back.
  const int all = nx + ny, x_begin = left == 0 ? 0 : ny;
  ConnectionLayout layout;
  layout.whole = {
      all, connection.whole_slots[(x_begin + x_back) % all], {x_front + y_front, left_end}, 0};
  layout.parts[left] = {nx, x[x_back % nx], {x_front, left_end}, 0};
  layout.parts[right] = {ny, y[0], {y_front, meeting}, x_front};
  return layout;
}

}  // namespace meshknit
