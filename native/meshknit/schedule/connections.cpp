#include "meshknit/schedule/connections.h"

#include <algorithm>
#include <string>

#include "meshknit/core/error.h"
#include "meshknit/knit_graph/ring_parts.h"

namespace meshknit {
namespace {

[[noreturn]] void refuse(const StitchTrace& trace, const SteppedTubes& tubes, int tube,
                         const std::string& why) {
  const int stitch = tubes.tubes[tube].steps.front().first_stitch;
  Problem problem;
  problem.code = "tubes-not-side-by-side";
  problem.message = "Where tubes part or meet at stitch " + std::to_string(stitch) + ", " + why;
  problem.remedy =
      "Change the knitting times there, so that there is a row of stitches between one branch "
      "and the next.";
  problem.elements.stitches = {stitch};
  problem.elements.nodes = {trace.stitches[stitch].node};
  throw NotKnittable({problem});
}

// Several tubes become one, or one becomes several, and every loop goes on.
void require_one_whole(const StitchTrace& trace, const SteppedTubes& tubes) {
  for (int t = 0; t < static_cast<int>(tubes.tubes.size()); ++t) {
    const TubeSteps& tube = tubes.tubes[t];
    if (tube.below.empty()) continue;
    std::size_t given = 0, taken = 0;
    bool good = true;
    for (const int below : tube.below) {
      good = good && (tube.below.size() == 1) == (tubes.tubes[below].above.size() > 1);
      given += tubes.tubes[below].end.size();
    }
    for (const int beside : tubes.tubes[tube.below[0]].above)
      taken += tubes.tubes[beside].origins.size();
    if (!good || given != taken) refuse(trace, tubes, t, "loops are lost or change tubes.");
  }
}

/// For each slot of the whole: which tube, and the slot there.
struct PartSlot {
  int part = 0, slot = 0;
};

std::vector<PartSlot> part_slots_of(const SteppedTubes& tubes, const Connection& connection) {
  std::vector<PartSlot> slots;
  if (connection.split) {
    slots.resize(tubes.tubes[connection.whole].end.size());
    for (const int part : tubes.tubes[connection.whole].above) {
      const std::vector<EndStack>& origins = tubes.tubes[part].origins;
      for (int slot = 0; slot < static_cast<int>(origins.size()); ++slot)
        slots[origins[slot].stack] = {part, slot};
    }
  } else {
    for (const EndStack& origin : tubes.tubes[connection.whole].origins)
      slots.push_back({origin.tube, origin.stack});
  }
  return slots;
}

// The loops of a part must come in its own cyclic order.
bool is_in_order(const std::vector<int>& part_slots) {
  const int n = static_cast<int>(part_slots.size());
  for (int i = 0; i + 1 < n; ++i)
    if (part_slots[i + 1] != (part_slots[i] + 1) % n) return false;
  return true;
}

void number_slots(const StitchTrace& trace, const SteppedTubes& tubes, Connection& connection) {
  const std::vector<PartSlot> slots = part_slots_of(tubes, connection);
  const int n = static_cast<int>(slots.size());
  std::vector<int> part_of;
  for (const PartSlot& slot : slots) part_of.push_back(slot.part);
  const std::vector<PartStretch> stretches = ring_parts(part_of);
  const std::size_t parts = stretches.size() / 2 + 1;
  const int first = connection.split ? connection.first : connection.whole;
  if (stretches.empty()) refuse(trace, tubes, first, "they do not lie side by side.");
  connection.part_slots.resize(parts);
  for (std::size_t k = 0; k < parts; ++k) connection.parts.push_back(stretches[k].part);
  for (std::size_t k = 0; k < stretches.size(); ++k)
    for (int i = 0; i < stretches[k].count; ++i) {
      const int at = (stretches[k].first + i) % n;
      connection.whole_slots.push_back(at);
      connection.part_slots[std::min(k, stretches.size() - k)].push_back(slots[at].slot);
    }
  // What one side of a middle part has more than the other tells how its ends lie.
  std::vector<int> sizes;
  for (const std::vector<int>& own : connection.part_slots) {
    sizes.push_back(static_cast<int>(own.size()));
    if (!is_in_order(own)) refuse(trace, tubes, first, "the loops of one are not in order.");
  }
  const auto fits = [&](const std::vector<int>& ends) {
    bool good = !ends.empty();
    for (std::size_t k = 1; good && k + 1 < parts; ++k)
      good = ends[k + 1] - ends[k] == sizes[k] - 2 * stretches[k].count;
    return good;
  };
  for (const int left : {0, -1}) {
    const std::vector<int> ends = aligned_ends(sizes, left);
    if (connection.ends.empty() && fits(ends)) connection.ends = ends;
  }
  if (connection.ends.empty())
    refuse(trace, tubes, first, "those in the middle cannot hang evenly on both beds.");
}

}  // namespace

std::vector<Connection> find_connections(const StitchTrace& trace, const SteppedTubes& tubes) {
  require_one_whole(trace, tubes);
  std::vector<Connection> connections;
  std::vector<bool> parted(tubes.tubes.size(), false);
  for (const SteppedTubes::Turn& turn : tubes.turns) {
    const TubeSteps& tube = tubes.tubes[turn.tube];
    if (turn.step > 0 || tube.below.empty()) continue;
    Connection connection;
    connection.split = tube.below.size() == 1;
    connection.whole = connection.split ? tube.below[0] : turn.tube;
    connection.first = turn.tube;
    if (connection.split && parted[connection.whole]) continue;
    parted[connection.whole] = connection.split;
    number_slots(trace, tubes, connection);
    connections.push_back(std::move(connection));
  }
  return connections;
}

ConnectionLayout connection_layout(const Connection& connection, int left) {
  // From the left: the tubes, their ends, and where each one's slots begin in the ring.
  const std::size_t parts = connection.parts.size();
  std::vector<std::size_t> order(parts);
  for (std::size_t k = 0; k < parts; ++k) order[k] = left == 0 ? k : parts - 1 - k;
  std::vector<int> ends = connection.ends;
  if (left != 0) std::reverse(ends.begin(), ends.end());

  ConnectionLayout layout;
  layout.parts.resize(parts);
  int place = 0;
  for (std::size_t k = 0; k < parts; ++k) {
    const std::vector<int>& slots = connection.part_slots[order[k]];
    const int n = static_cast<int>(slots.size());
    const int front = (n - (ends[k + 1] - ends[k])) / 2;
    // The slot at the front's left end. The ring runs from parts[0] out on the one bed and back on
    // the other; the left part's slots begin on the back bed, as whole_slots does.
    int begin = 0;
    if (k == 0)
      begin = (n - front) % n;
    else if (left != 0 && k + 1 < parts)
      begin = n - front;
    layout.parts[order[k]] = {n, slots[begin], {front, ends[k]}, place};
    place += front;
  }
  const int all = static_cast<int>(connection.whole_slots.size());
  const BedLayout& leftmost = layout.parts[order[0]];
  // Round the ring from parts[0]: all of it, the middle parts' first sides, then the last part.
  int begin = 0;
  if (left != 0) {
    begin = static_cast<int>(connection.part_slots.front().size());
    for (std::size_t k = 1; k + 1 < parts; ++k) {
      const BedLayout& middle = layout.parts[k];
      begin += middle.slots - middle.shape.front;
    }
  }
  layout.whole = {all,
                  connection.whole_slots[(begin + leftmost.slots - leftmost.shape.front) % all],
                  {place, ends.front()},
                  0};
  return layout;
}

}  // namespace meshknit
