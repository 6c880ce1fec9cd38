#include "meshknit/transfer/stop.h"

#include <cstdlib>

namespace meshknit {

bool operator==(const Stop& a, const Stop& b) {
  return a.side == b.side && a.place == b.place && a.parked == b.parked;
}

int position(const Stop& stop, int racking) {
  const Needle needle = half_gauge_needle({stop.bed(), stop.place, stop.parked});
  return needle.bed == Bed::back ? needle.index + racking : needle.index;
}

bool one_needle(const Stop& a, const Stop& b) {
  return a.parked == b.parked && a.place == b.place && a.bed() == b.bed();
}

bool in_order(const Stop& a, const Stop& b, int racking) {
  if (a.side != b.side) return a.side < b.side;
  const int ahead = position(b, racking) - position(a, racking);
  return bed_of_side(a.side) == Bed::front ? ahead >= 0 : ahead <= 0;
}

long remaining_way(const Tube& tube, const Stack& stack, const Stop& stop) {
  int side = stop.side, place = stop.place;
  long way = 0;
  while (side != stack.goal_side) {
    const bool anticlockwise = side < stack.goal_side;
    const bool right_end = (bed_of_side(side) == Bed::front) == anticlockwise;
    const int end = right_end ? tube.right_end : tube.left_end;
    way += std::abs(end - place) + 2;
    place = end;
    side += anticlockwise ? 1 : -1;
  }
  return way + std::abs(stack.goal - place);
}

}  // namespace meshknit
