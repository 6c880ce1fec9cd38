#pragma once

#include <vector>

#include "meshknit/machine/needle.h"

namespace meshknit {

/// One carriage pass of transfers: from one bed to the other at one racking (real needles).
struct Pass {
  Bed from = Bed::front;
  int racking = 0;
};
using Passes = std::vector<Pass>;

/// At an even racking hooks face parking needles: loops are parked or come back, all on their
/// own side. At an odd one hooks face hooks: loops change beds round an end of the tube.
inline bool changes_side(const Pass& pass) { return pass.racking % 2 != 0; }

/// How many half-gauge places to the right a loop comes down in this pass, beside the place it
/// hung on.
int shift_of(const Pass& pass);

/// Racking travelled from 0 through the passes and back to 0, in real needles.
int racking_travel(const Passes& passes);

}  // namespace meshknit
