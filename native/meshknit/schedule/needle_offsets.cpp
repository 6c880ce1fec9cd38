#include "meshknit/schedule/needle_offsets.h"

#include <algorithm>

#include "meshknit/schedule/layout_cost.h"

namespace meshknit {
namespace {

constexpr int kFreePlaces = 4;  // at each end of the bed
constexpr PlaceRange kAnywhere{-100000, 100000};
constexpr int kFurthest = 2;  // places that one racking moves a whole tube

// Twice the middle, so that it stays an integer.
int middle(const PlaceRange& range) { return range.lowest + range.highest; }

int width(const PlaceRange& range) { return range.highest - range.lowest + 1; }

PlaceRange unite(const PlaceRange& a, const PlaceRange& b) {
  return {std::min(a.lowest, b.lowest), std::max(a.highest, b.highest)};
}

class BedWalk {
 public:
  BedWalk(const SteppedTubes& tubes, const std::vector<Connection>& connections,
          const BedOrder& order, const std::vector<TubeLayouts>& layouts,
          const PlaceRange& walls, int start_middle)
      : tubes_(tubes),
        connections_(connections),
        order_(order),
        layouts_(layouts),
        walls_(walls),
        start_middle_(start_middle),
        hung_(tubes.tubes.size()) {}

  PlacedTubes run() {
    for (size_t turn = 0; turn < tubes_.turns.size(); ++turn) {
      held_ = &order_.held[turn];
      const SteppedTubes::Turn& at = tubes_.turns[turn];
      if (at.step == 0) begin(at.tube);
      knit(at.tube, at.step);
    }
    return std::move(result_);
  }

  const PlaceRange& used() const { return used_; }

 private:
  struct Hung {
    BedLayout layout;
    int changes = 0;        // of its layout so far
    int wanted_middle = 0;  // twice
    bool hangs = false;
  };

  PlaceRange places(int tube) const { return places_of(hung_[tube].layout); }
  size_t row_of(int tube) const {
    return static_cast<size_t>(std::find(held_->begin(), held_->end(), tube) - held_->begin());
  }

  // What walls and neighbours leave for a tube.
  PlaceRange free_places(size_t row) const { return between(row, kFreeBetween, walls_); }
  // What its transfers may use.
  PlaceRange room(size_t row) const { return between(row, 0, kAnywhere); }

  PlaceRange between(size_t row, int apart, PlaceRange range) const {
    for (size_t left = row; left-- > 0;)
      if (hung_[(*held_)[left]].hangs) {
        range.lowest = std::max(range.lowest, places((*held_)[left]).highest + 1 + apart);
        break;
      }
    for (size_t right = row + 1; right < held_->size(); ++right)
      if (hung_[(*held_)[right]].hangs) {
        range.highest = std::min(range.highest, places((*held_)[right]).lowest - 1 - apart);
        break;
      }
    return range;
  }

  void hang(int tube, BedLayout layout, int place) {
    layout.place = place;
    hung_[tube].layout = layout;
    hung_[tube].hangs = true;
    hung_[tube].wanted_middle = middle(places_of(layout));
    use(places_of(layout));
  }

  void use(const PlaceRange& range) {
    used_ = any_used_ ? unite(used_, range) : range;
    any_used_ = true;
  }

  void begin(int tube) {
    if (hung_[tube].hangs) return;  // the other part of a split has begun before
    if (tubes_.tubes[tube].below.empty()) return start(tube);
    for (size_t c = 0; c < connections_.size(); ++c) {
      const Connection& connection = connections_[c];
      const int left = order_.left_part[c];
      if (connection.split && connection.parts[0] == tube) part(connection, left);
      if (!connection.split && connection.whole == tube) meet(connection, left);
    }
  }

  void start(int tube) {
    const BedLayout& layout = layouts_[tube].layouts.front();
    BedLayout at_zero = layout;
    at_zero.place = 0;
    const PlaceRange extent = places_of(at_zero);
    const size_t row = row_of(tube);
    PlaceRange range = free_places(row);
    if (width(range) < width(extent)) range = make_room(row, width(extent));
    // Beside the neighbour, if there is one on one side only.
    int wanted = (start_middle_ - middle(extent)) / 2;
    const bool left = row > 0, right = row + 1 < held_->size();
    if (left) wanted = range.lowest - extent.lowest;
    if (right && !left) wanted = range.highest - extent.highest;
    hang(tube, layout,
         std::clamp(wanted, range.lowest - extent.lowest, range.highest - extent.highest));
  }

  void part(const Connection& connection, int left) {
    const ConnectionLayout layout = connection_layout(connection, left);
    Hung& whole = hung_[connection.whole];
    for (const int p : {0, 1})
      hang(connection.parts[p], layout.parts[p], whole.layout.place + layout.parts[p].place);
    whole.hangs = false;
  }

  void meet(const Connection& connection, int left) {
    const ConnectionLayout layout = connection_layout(connection, left);
    const int x = connection.parts[left], y = connection.parts[1 - left];
    // The row of tubes knows the whole already; its parts stand in for it.
    std::vector<int> row = *held_;
    const auto whole = std::find(row.begin(), row.end(), connection.whole);
    *whole = y;
    row.insert(whole, x);
    const std::vector<int>* held = held_;
    held_ = &row;
    const int gap =
        hung_[y].layout.place - hung_[x].layout.place - layout.parts[1 - left].place;
    if (hung_[x].layout.slots < hung_[y].layout.slots)
      shift(x, gap);
    else
      shift(y, -gap);
    held_ = held;
    hung_[x].hangs = hung_[y].hangs = false;
    hang(connection.whole, layout.whole, hung_[x].layout.place);
  }

  // Moves a whole tube, as far at a time as a racking goes.
  void shift(int tube, int places_on) {
    while (places_on != 0) {
      const int now = std::clamp(places_on, -kFurthest, kFurthest);
      PlacedStep move;
      move.tube = tube;
      move.room = room(row_of(tube));
      move.before = move.after = hung_[tube].layout;
      move.after.place += now;
      hung_[tube].layout = move.after;
      hung_[tube].wanted_middle += 2 * now;
      use(places_of(move.after));
      result_.steps.push_back(move);
      places_on -= now;
    }
  }

  // Stacks that must move if a row of tubes from `row` on moves that way, up to the first gap.
  int stacks_in_the_way(size_t row, bool right, int distance) const {
    int stacks = 0;
    for (size_t at = row; at < held_->size() && distance > 0; right ? ++at : --at) {
      stacks += hung_[(*held_)[at]].layout.slots;
      const PlaceRange range = free_places(at);
      const PlaceRange own = places((*held_)[at]);
      distance -= right ? range.highest - own.highest : own.lowest - range.lowest;
    }
    return stacks;
  }

  // How far a row of tubes from `row` on can move until it stands at the wall.
  int way_to_wall(size_t row, bool right) const {
    int way = 0;
    for (size_t at = row; at < held_->size(); right ? ++at : --at) {
      const PlaceRange range = free_places(at);
      const PlaceRange own = places((*held_)[at]);
      way += std::max(0, right ? range.highest - own.highest : own.lowest - range.lowest);
    }
    return way;
  }

  // Moves the tube in this row, and those behind it that are in its way.
  void push(size_t row, bool right, int distance) {
    const int tube = (*held_)[row];
    const PlaceRange range = free_places(row), own = places(tube);
    const int free = right ? range.highest - own.highest : own.lowest - range.lowest;
    const size_t next = right ? row + 1 : row - 1;
    if (free < distance && next < held_->size()) push(next, right, distance - free);
    shift(tube, right ? distance : -distance);
  }

  // Pushes neighbours away until `wanted` places are free between them.
  PlaceRange make_room(size_t row, int wanted) {
    result_.optimal = false;
    const auto missing = [&] { return wanted - width(free_places(row)); };
    const bool can_left = row > 0, can_right = row + 1 < held_->size();
    bool right = can_right;
    if (can_left && can_right)
      right = stacks_in_the_way(row + 1, true, missing()) <=
              stacks_in_the_way(row - 1, false, missing());
    for (const bool way : {right, !right}) {
      if (missing() <= 0 || !(way ? can_right : can_left)) continue;
      const size_t neighbour = way ? row + 1 : row - 1;
      push(neighbour, way, std::min(missing(), way_to_wall(neighbour, way)));
    }
    return free_places(row);
  }

  void knit(int tube, int step) {
    Hung& hung = hung_[tube];
    const TubeLayouts& own = layouts_[tube];
    const bool changes =
        hung.changes < static_cast<int>(own.maps.size()) && own.from_step[hung.changes] == step;
    PlacedStep placed;
    BedLayout next = changes ? own.layouts[hung.changes + 1] : hung.layout;
    next.place = hung.layout.place;
    const size_t row = row_of(tube);
    PlaceRange range = free_places(row);
    if (width(range) < width(places_of(next))) range = make_room(row, width(places_of(next)));

    const PlaceRange unmoved = places_of(next);
    OffsetChoice choice{range.lowest - unmoved.lowest, range.highest - unmoved.highest, 0};
    choice.liked = liked_offset(tube, row, unmoved, choice);
    placed.tube = tube;
    placed.step = step;
    placed.before = hung.layout;
    if (changes) {
      const ShiftCost cost = meter_.measure(own.maps[hung.changes], hung.layout, next, choice);
      const ShiftCost best = meter_.measure(own.maps[hung.changes], hung.layout, next);
      if (best < cost) result_.optimal = false;
      next.place += cost.offset;
      ++hung.changes;
    } else {
      next.place += std::clamp(0, choice.lowest, choice.highest);
    }
    placed.after = next;
    placed.room = room(row);
    hung.layout = next;
    use(places_of(next));
    result_.steps.push_back(placed);
  }

  int liked_offset(int tube, size_t row, const PlaceRange& unmoved,
                   const OffsetChoice& choice) {
    for (size_t c = 0; c < connections_.size(); ++c) {
      const Connection& connection = connections_[c];
      if (connection.split || (connection.parts[0] != tube && connection.parts[1] != tube))
        continue;
      const bool is_left = connection.parts[order_.left_part[c]] == tube;
      const int other = connection.parts[connection.parts[0] == tube ? 1 : 0];
      const size_t beside = is_left ? row + 1 : row - 1;
      if (beside < held_->size() && (*held_)[beside] == other)
        return is_left ? choice.highest : choice.lowest;
    }
    return (hung_[tube].wanted_middle - middle(unmoved)) / 2;
  }

  const SteppedTubes& tubes_;
  const std::vector<Connection>& connections_;
  const BedOrder& order_;
  const std::vector<TubeLayouts>& layouts_;
  PlaceRange walls_;
  int start_middle_;
  std::vector<Hung> hung_;                  // [tube]
  const std::vector<int>* held_ = nullptr;  // left to right
  PlaceRange used_;
  bool any_used_ = false;
  ShiftMeter meter_;
  PlacedTubes result_;
};

void move_all(PlacedTubes& placed, int offset, const PlaceRange& bed) {
  for (PlacedStep& step : placed.steps) {
    step.before.place += offset;
    step.after.place += offset;
    step.room = {std::max(bed.lowest, step.room.lowest + offset),
                 std::min(bed.highest, step.room.highest + offset)};
  }
}

}  // namespace

PlaceRange usable_places(const MachineProfile& profile) {
  // Place n is needles 2n and 2n + 1 of both beds, which are numbered from 1.
  return {1 + kFreePlaces, profile.needles / 2 - 1 - kFreePlaces};
}

PlacedTubes place_tubes(const SteppedTubes& tubes, const std::vector<Connection>& connections,
                        const BedOrder& order, const std::vector<TubeLayouts>& layouts,
                        const MachineProfile& profile) {
  const PlaceRange usable = usable_places(profile), bed{1, profile.needles / 2 - 1};
  BedWalk free_walk(tubes, connections, order, layouts, kAnywhere, 0);
  PlacedTubes placed = free_walk.run();
  if (width(free_walk.used()) <= width(usable)) {
    move_all(placed, (middle(usable) - middle(free_walk.used())) / 2, bed);
    return placed;
  }
  placed = BedWalk(tubes, connections, order, layouts, usable, middle(usable)).run();
  placed.optimal = false;
  move_all(placed, 0, bed);
  return placed;
}

}  // namespace meshknit
