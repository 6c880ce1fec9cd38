#pragma once

#include <vector>

#include "meshknit/remesh/peel.h"

namespace meshknit {

/// Thrown where joined saddles (joined_saddles.h) cannot be knit in one row after all: fine vertices
/// of the saddles, to be kept apart.
struct NotInOneRow {
  std::vector<int> saddles;
};

/// Knits the step over a saddle, where tubes split or merge (paper, 3.2.3 and appendix A): the rows
/// a row's height above the last rows of the tubes below, whole and linked one to one
/// (Property 5), each tube's part of the other side's row in one piece (Property 6).
/// `below` follows ReebEvent::below: last rows of these tubes, whole. Returns the first rows of the
/// tubes above, which follow ReebEvent::above.
/// Where three or more tubes part or meet in one row, they hang side by side, and the middle ones have
/// as many stitches on the one bed as on the other, or one more (side_by_side.h).
/// Throws: NotKnittable "junction-too-tight", with faces near the saddle; NotInOneRow.
std::vector<ActiveCycle> knit_junction(Peel& peel, int event,
                                       const std::vector<ActiveCycle>& below);

}  // namespace meshknit
