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

  // The nearest tube that hangs on that side; -1 for none.
  int neighbour(size_t row, bool right) const {
    for (size_t at = right ? row + 1 : row - 1; at < held_->size(); right ? ++at : --at)
      if (hung_[(*held_)[at]].hangs) return (*held_)[at];
    return -1;
  }

  // By how much a layout in this row may move so that walls and neighbours leave it room.
  OffsetChoice free_offsets(size_t row, const BedLayout& layout) const {
    const PlaceRange own = places_of(layout);
    OffsetChoice free{walls_.lowest - own.lowest, walls_.highest - own.highest, 0};
    if (const int left = neighbour(row, false); left >= 0)
      free.lowest =
          std::max(free.lowest, kFreeBetween - places_between(hung_[left].layout, layout));
    if (const int right = neighbour(row, true); right >= 0)
      free.highest =
          std::min(free.highest, places_between(layout, hung_[right].layout) - kFreeBetween);
    return free;
  }

  // What the tube's transfers may use: its own places, and those up to its neighbours.
  PlaceRange room(size_t row, const PlacedStep& step) const {
    PlaceRange range = kAnywhere;
    if (const int left = neighbour(row, false); left >= 0)
      range.lowest = places(left).highest + 1;
    if (const int right = neighbour(row, true); right >= 0)
      range.highest = places(right).lowest - 1;
    return unite(range, unite(places_of(step.before), places_of(step.after)));
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
    const size_t row = row_of(tube);
    OffsetChoice free = free_offsets(row, layout);
    if (free.lowest > free.highest) free = make_room(row, layout);
    // Beside the neighbour, if there is one on one side only.
    int wanted = (start_middle_ - middle(places_of(layout))) / 2;
    const bool left = row > 0, right = row + 1 < held_->size();
    if (left) wanted = free.lowest;
    if (right && !left) wanted = free.highest;
    hang(tube, layout, layout.place + std::clamp(wanted, free.lowest, free.highest));
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
      move.before = move.after = hung_[tube].layout;
      move.after.place += now;
      move.room = room(row_of(tube), move);
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
      distance -= free_way(at, right);
    }
    return stacks;
  }

  // How far the tube in this row can move without pushing another.
  int free_way(size_t row, bool right) const {
    const OffsetChoice free = free_offsets(row, hung_[(*held_)[row]].layout);
    return std::max(0, right ? free.highest : -free.lowest);
  }

  // How far a row of tubes from `row` on can move until it stands at the wall.
  int way_to_wall(size_t row, bool right) const {
    int way = 0;
    for (size_t at = row; at < held_->size(); right ? ++at : --at) way += free_way(at, right);
    return way;
  }

  // Moves the tube in this row, and those behind it that are in its way.
  void push(size_t row, bool right, int distance) {
    const int free = free_way(row, right);
    const size_t next = right ? row + 1 : row - 1;
    if (free < distance && next < held_->size()) push(next, right, distance - free);
    shift((*held_)[row], right ? distance : -distance);
  }

  // Pushes neighbours away until the layout has room between them.
  OffsetChoice make_room(size_t row, const BedLayout& layout) {
    result_.optimal = false;
    const auto missing = [&] {
      const OffsetChoice free = free_offsets(row, layout);
      return free.lowest - free.highest;
    };
    const bool can_left = row > 0, can_right = row + 1 < held_->size();
    bool right = can_right;
    if (can_left && can_right)
      right = stacks_in_the_way(row + 1, true, missing()) <=
              stacks_in_the_way(row - 1, false, missing());
    for (const bool way : {right, !right}) {
      if (missing() <= 0 || !(way ? can_right : can_left)) continue;
      const size_t beside = way ? row + 1 : row - 1;
      push(beside, way, std::min(missing(), way_to_wall(beside, way)));
    }
    return free_offsets(row, layout);
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
    OffsetChoice choice = free_offsets(row, next);
    if (choice.lowest > choice.highest) choice = make_room(row, next);
    choice.liked = liked_offset(tube, row, places_of(next), choice);
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
    placed.room = room(row, placed);
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
