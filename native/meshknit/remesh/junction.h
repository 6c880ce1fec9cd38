#pragma once

#include <vector>

#include "meshknit/remesh/peel.h"

namespace meshknit {

/// Knits the step over a saddle, where tubes split or merge (paper, 3.2.3 and appendix A): the rows
/// a row's height above the last rows of the tubes below, whole and linked one to one
/// (Property 5), each tube's part of the other side's row in one piece (Property 6).
/// `below` follows ReebEvent::below: last rows of these tubes, whole. Returns the first rows of the
/// tubes above, which follow ReebEvent::above.
/// Throws: NotKnittable "junction-too-tight", with faces near the saddle.
std::vector<ActiveCycle> knit_junction(Peel& peel, int event,
                                       const std::vector<ActiveCycle>& below);

}  // namespace meshknit
