#include "meshknit/verify/tubes.h"

#include <algorithm>

namespace meshknit {
namespace {

// Where a needle stands on the circle of both beds.
int on_circle(const Needle& needle) {
  constexpr int kRound = 1 << 28;  // beyond every needle number
  const int key = 2 * needle.index + (needle.slider ? 1 : 0);
  return needle.bed == Bed::front ? key : kRound - key;
}

// Strictly between two places when going anticlockwise from one to the other.
bool on_the_way(int from, int place, int to) {
  if (from < to) return from < place && place < to;
  return place > from || place < to;
}

bool has_column_between(const TubeOrder& order, const Needle& from, const Needle& to) {
  const int first = order.first_after(from);
  return first >= 0 &&
         on_the_way(on_circle(from), on_circle(order.needle(first)), on_circle(to));
}

}  // namespace

int Tubes::begin(const Needle& needle) {
  tubes_.emplace_back();
  const int tube = static_cast<int>(tubes_.size()) - 1;
  hold(tube, true);
  return insert(tube, needle);
}

int Tubes::insert(int tube, const Needle& needle) {
  const int column = static_cast<int>(columns_.size());
  columns_.push_back({tube, tubes_[tube].order.insert(needle)});
  tubes_[tube].columns.push_back(column);
  return column;
}

void Tubes::move(int column, const Needle& to) {
  const Column& c = columns_[column];
  tubes_[c.tube].order.move(c.own, to);
}

void Tubes::remove(int column) {
  Column& c = columns_[column];
  TubeOrder& order = tubes_[c.tube].order;
  order.remove(c.own);
  if (order.size() == 0) hold(c.tube, false);
  c.tube = -1;
}

int Tubes::meet(int first, int second) {
  const int tube = columns_[first].tube;
  const int other = columns_[second].tube;
  if (tube != other) {
    Ring ring = ring_from(second);
    const Ring rest = ring_from(next(first));
    ring.insert(ring.end(), rest.begin(), rest.end());
    tubes_[other] = Tube();
    hold(other, false);
    fill(tube, ring);
    return -1;
  }
  const Ring ring = ring_from(second);
  const auto cut = std::find_if(ring.begin(), ring.end(),
                                [&](const auto& entry) { return entry.first == first; }) +
                   1;
  fill(tube, {ring.begin(), cut});
  if (cut == ring.end()) return -1;
  tubes_.emplace_back();
  const int parted = static_cast<int>(tubes_.size()) - 1;
  hold(parted, true);
  fill(parted, {cut, ring.end()});
  return parted;
}

Needle Tubes::needle(int column) const {
  const Column& c = columns_[column];
  return tubes_[c.tube].order.needle(c.own);
}

int Tubes::next(int column) const {
  const Column& c = columns_[column];
  return tubes_[c.tube].columns[tubes_[c.tube].order.next(c.own)];
}

int Tubes::previous(int column) const {
  const Column& c = columns_[column];
  return tubes_[c.tube].columns[tubes_[c.tube].order.previous(c.own)];
}

bool Tubes::crosses(int column, int other) const {
  const TubeOrder& own = tubes_[columns_[column].tube].order;
  const Needle here = needle(column);
  const Needle before = own.needle(own.last_before(here));
  const Needle after = own.needle(own.first_after(here));
  if (before == here) return false;
  const TubeOrder& order = tubes_[other].order;
  return has_column_between(order, before, here) && has_column_between(order, here, after);
}

bool Tubes::tube_crosses(int tube, int other) const {
  const TubeOrder& own = tubes_[tube].order;
  if (own.size() == 0 || tubes_[other].order.size() == 0) return false;
  int gaps = 0;  // between two columns of the tube, with columns of the other
  Needle here = own.needle(own.leftmost(own.is_on(Bed::front) ? Bed::front : Bed::back));
  for (int k = 0; k < own.size(); ++k) {
    const Needle after = own.needle(own.first_after(here));
    if (has_column_between(tubes_[other].order, here, after)) ++gaps;
    here = after;
  }
  return gaps > 1;
}

bool Tubes::lies_between(int tube, const Needle& a, const Needle& b) const {
  if (a == b) return false;
  const TubeOrder& order = tubes_[tube].order;
  return has_column_between(order, a, b) && has_column_between(order, b, a);
}

int Tubes::side(int tube, int other) const {
  int side = 0;
  for (const Bed bed : {Bed::front, Bed::back}) {
    const TubeOrder& a = tubes_[tube].order;
    const TubeOrder& b = tubes_[other].order;
    if (!a.is_on(bed) || !b.is_on(bed)) continue;
    const int here = a.needle(a.rightmost(bed)) < b.needle(b.leftmost(bed))   ? 1
                     : b.needle(b.rightmost(bed)) < a.needle(a.leftmost(bed)) ? -1
                                                                              : 0;
    if (here == 0 || here == -side) return 0;
    side = here;
  }
  return side;
}

// The columns of the ring and their needles, anticlockwise from this one.
Tubes::Ring Tubes::ring_from(int column) const {
  Ring ring;
  int at = column;
  do {
    ring.emplace_back(at, needle(at));
    at = next(at);
  } while (at != column);
  return ring;
}

void Tubes::fill(int tube, const Ring& ring) {
  Tube filled;
  int last = -1;
  for (const auto& [column, needle] : ring) {
    last = filled.order.insert_after(last, needle);
    filled.columns.push_back(column);
    columns_[column] = {tube, last};
  }
  tubes_[tube] = std::move(filled);
}

void Tubes::hold(int tube, bool held) {
  const auto at = std::lower_bound(held_.begin(), held_.end(), tube);
  if (held) {
    held_.insert(at, tube);
  } else {
    held_.erase(at);
  }
}

}  // namespace meshknit
