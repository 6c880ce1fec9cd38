#include "meshknit/schedule/bed_row.h"

#include <algorithm>
#include <optional>
#include <tuple>

namespace meshknit {
namespace {

constexpr int kFurthest = 2;  // places that one racking moves a whole tube

PlaceRange unite(const PlaceRange& a, const PlaceRange& b) {
  return {std::min(a.lowest, b.lowest), std::max(a.highest, b.highest)};
}

// Places free between two tubes for either one's transfers. A front loop on the lowest place of a
// room, or a back loop on its highest, would leave the planner none beside it (emit/step_transfers).
int places_to_spare(const BedLayout& left, const BedLayout& right) {
  const int left_back_end = left.place + left.shape.left + left.slots - left.shape.front - 1;
  return std::min({places_between(left, right), right.place - places_of(left).highest - 1,
                   places_of(right).lowest - left_back_end - 1});
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
        std::max(free.lowest, kFreeBetween - places_to_spare(hung_[left].layout, layout));
  if (const int right = neighbour(row, true); right >= 0)
    free.highest =
        std::min(free.highest, places_to_spare(layout, hung_[right].layout) - kFreeBetween);
  return free;
}

void BedRow::write_down(int tube, int step, const BedLayout& after) {
  PlacedStep placed{tube, step, hung_[tube].layout, after, kAnywhere, 1};
  for (const int other : order_)
    if (other != tube && hung_[other].hangs)
      placed.bridge_beside =
          std::max(placed.bridge_beside, longest_bridge(hung_[other].layout));
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

// Moves the tube in this row, and before it those that are in its way. Tubes that have just parted go
// place by place, in turn: the yarn between them bears no more.
void BedRow::push(std::size_t row, bool right, int distance) {
  const std::size_t next = right ? row + 1 : row - 1;
  const int at_once = is_tied(row, right) ? kFreeBetween : distance;
  for (int left = distance; left > 0; left -= at_once) {
    const int now = std::min(left, at_once), free = free_way(row, right);
    if (free < now && next < order_.size()) push(next, right, now - free);
    shift(order_[row], right ? now : -now);
  }
}

// Tubes touch only where they have just parted: the yarn of their last common row still runs from
// one to the other, too short for them ever to be more than a place apart.
bool BedRow::is_tied(std::size_t row, bool right) const {
  const int beside = neighbour(row, right);
  if (beside < 0 || !hung_[order_[row]].hangs) return false;
  const BedLayout &own = hung_[order_[row]].layout, &other = hung_[beside].layout;
  return (right ? places_between(own, other) : places_between(other, own)) == 0;
}

void BedRow::make_room(std::size_t row, const BedLayout& layout) {
  pushed_ = true;
  const OffsetChoice free = free_offsets(row, layout);
  const int missing = free.lowest - free.highest;
  const int most_left = row > 0 ? way_to_wall(row - 1, false) : 0;
  const int most_right = row + 1 < order_.size() ? way_to_wall(row + 1, true) : 0;
  // Places to make on the left, the others on the right: so that all go at once, fewest stacks move,
  // its own counted unless it can stay, and in equally good ways least far.
  std::optional<std::tuple<bool, int, int, int>> best;
  for (int left = std::max(0, missing - most_right); left <= std::min(missing, most_left);
       ++left) {
    const int right = missing - left, own = free.lowest - left;
    int stacks = own == 0 ? 0 : layout.slots;
    if (left > 0) stacks += stacks_in_the_way(row - 1, false, left);
    if (right > 0) stacks += stacks_in_the_way(row + 1, true, right);
    const bool in_turn = (left > kFreeBetween && is_tied(row, false)) ||
                         (right > kFreeBetween && is_tied(row, true));
    const std::tuple<bool, int, int, int> cost{in_turn, stacks, std::max(left, right), left};
    if (!best || cost < *best) best = cost;
  }
  if (!best) return;
  const int left = std::get<3>(*best);
  clear_side(row, false, left);
  clear_side(row, true, missing - left);
}

// A neighbour that has just parted from the tube goes place by place, and the tube after it.
void BedRow::clear_side(std::size_t row, bool right, int distance) {
  const std::size_t next = right ? row + 1 : row - 1;
  const bool tied = is_tied(row, right);
  for (; tied && distance > kFreeBetween; distance -= kFreeBetween) {
    push(next, right, kFreeBetween);
    shift(order_[row], right ? kFreeBetween : -kFreeBetween);
  }
  if (distance > 0) push(next, right, distance);
}

}  // namespace meshknit
