#pragma once

#include "meshknit/transfer/tube.h"

namespace meshknit {

/// Where a stack hangs between two passes.
struct Stop {
  int side = 0;
  int place = 0;
  bool parked = false;

  Bed bed() const { return parked ? opposite(bed_of_side(side)) : bed_of_side(side); }
};
bool operator==(const Stop& a, const Stop& b);

/// Where it is across the machine at this racking, in front needles.
int position(const Stop& stop, int racking);

bool one_needle(const Stop& a, const Stop& b);

/// True if `b` does not come before `a` on the way anticlockwise: the front rightward, the back
/// leftward; a facing neighbour is still in order.
bool in_order(const Stop& a, const Stop& b, int racking);

/// The way that still lies before a stack of this tube, in places, and 2 for every end that it
/// must go round (knitout primer, 4.1).
long remaining_way(const Tube& tube, const Stack& stack, const Stop& stop);

}  // namespace meshknit
