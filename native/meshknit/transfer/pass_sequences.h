#pragma once

#include <vector>

#include "meshknit/transfer/pass.h"
#include "meshknit/transfer/tube.h"

namespace meshknit {

/// All sequences of this many passes in which every stack of the tube could come home if it
/// were alone, in the order of their racking travel. Empty as well if there are too many
/// sequences to look at (`gave_up`).
struct PassSequences {
  std::vector<Passes> sequences;
  bool gave_up = false;
};
PassSequences sequences_of_length(const Tube& tube, int length);

/// The same for sequences of one to three legs: runs of passes in one direction whose even
/// rackings rise or fall by steps of 2, each leg against the direction of the one before.
std::vector<Passes> sequences_in_legs(const Tube& tube, int length);

}  // namespace meshknit
