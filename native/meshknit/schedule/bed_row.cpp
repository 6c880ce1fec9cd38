#include "meshknit/schedule/bed_row.h"

#include <algorithm>

namespace meshknit {
namespace {

constexpr int kFurthest = 2;  // places that one racking moves a whole tube

PlaceRange unite(const PlaceRange& a, const PlaceRange& b) {
  return {std::min(a.lowest, b.lowest), std::max(a.highest, b.highest)};
}

}  // namespace

std::size_t BedRow::row_of(int tube) const {
  return static_cast<std::size_t>(std::find(order_.begin(), order_.end(), tube) -
                                  order_.begin());
}

void BedRow::hang(int tube, const BedLayout& layout) {
  const PlaceRange places = places_of(layout);
  hung_[tube] = {layout, places.lowest + places.highest, true};
  use(places);
}

void BedRow::use(const PlaceRange& range) {
  used_ = any_used_ ? unite(used_, range) : range;
  any_used_ = true;
}

// The nearest tube that hangs on that side; -1 for none.
int BedRow::neighbour(std::size_t row, bool right) const {
  for (std::size_t at = right ? row + 1 : row - 1; at < order_.size(); right ? ++at : --at)
    if (hung_[order_[at]].hangs) return order_[at];
  return -1;
}

OffsetChoice BedRow::free_offsets(std::size_t row, const BedLayout& layout) const {
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

void BedRow::write_down(int tube, int step, const BedLayout& after) {
  PlacedStep placed{tube, step, hung_[tube].layout, after, kAnywhere};
  const std::size_t row = row_of(tube);
  if (const int left = neighbour(row, false); left >= 0)
    placed.room.lowest = places_of(hung_[left].layout).highest + 1;
  if (const int right = neighbour(row, true); right >= 0)
    placed.room.highest = places_of(hung_[right].layout).lowest - 1;
  placed.room = unite(placed.room, unite(places_of(placed.before), places_of(after)));
  steps_.push_back(placed);
  hung_[tube].layout = after;
  use(places_of(after));
}

void BedRow::knit(int tube, int step, const BedLayout& after) { write_down(tube, step, after); }

void BedRow::shift(int tube, int places) {
  while (places != 0) {
    const int now = std::clamp(places, -kFurthest, kFurthest);
    BedLayout after = hung_[tube].layout;
    after.place += now;
    write_down(tube, -1, after);
    hung_[tube].middle += 2 * now;
    places -= now;
  }
}

// How far the tube in this row can move without pushing another.
int BedRow::free_way(std::size_t row, bool right) const {
  const OffsetChoice free = free_offsets(row, hung_[order_[row]].layout);
  return std::max(0, right ? free.highest : -free.lowest);
}

// How far a row of tubes from `row` on can move until it stands at the wall.
int BedRow::way_to_wall(std::size_t row, bool right) const {
  int way = 0;
  for (std::size_t at = row; at < order_.size(); right ? ++at : --at)
    way += free_way(at, right);
  return way;
}

// Stacks that must move if the tubes from `row` on move that way, up to the first gap.
int BedRow::stacks_in_the_way(std::size_t row, bool right, int distance) const {
  int stacks = 0;
  for (std::size_t at = row; at < order_.size() && distance > 0; right ? ++at : --at) {
    stacks += hung_[order_[at]].layout.slots;
    distance -= free_way(at, right);
  }
  return stacks;
}

// Moves the tube in this row, and before it those that are in its way.
void BedRow::push(std::size_t row, bool right, int distance) {
  const int free = free_way(row, right);
  const std::size_t next = right ? row + 1 : row - 1;
  if (free < distance && next < order_.size()) push(next, right, distance - free);
  shift(order_[row], right ? distance : -distance);
}

OffsetChoice BedRow::make_room(std::size_t row, const BedLayout& layout) {
  pushed_ = true;
  const auto missing = [&] {
    const OffsetChoice free = free_offsets(row, layout);
    return free.lowest - free.highest;
  };
  const bool can_left = row > 0, can_right = row + 1 < order_.size();
  bool right = can_right;
  if (can_left && can_right)
    right = stacks_in_the_way(row + 1, true, missing()) <=
            stacks_in_the_way(row - 1, false, missing());
  for (const bool way : {right, !right}) {
    if (missing() <= 0 || !(way ? can_right : can_left)) continue;
    const std::size_t beside = way ? row + 1 : row - 1;
    push(beside, way, std::min(missing(), way_to_wall(beside, way)));
  }
  return free_offsets(row, layout);
}

}  // namespace meshknit
