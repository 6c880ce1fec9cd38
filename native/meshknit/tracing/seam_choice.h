#pragma once

#include <vector>

#include "meshknit/tracing/tube_events.h"

namespace meshknit {

/// The tubes after these ones were cut across: each ends at its seam, and what was above it starts
/// anew as another tube, numbered from tubes.size() on in the order of `cut`.
std::vector<TubeLinks> cut_tubes(std::vector<TubeLinks> tubes, const std::vector<int>& cut);

/// What tubes that would have to cross need.
struct SeamChoice {
  bool needed = false;     ///< the tubes cannot hang as they are
  std::vector<int> tubes;  ///< to cut, ascending; empty if none is needed or nothing helps
};

/// The fewest tubes to cut so that all can hang side by side, of these the ones with the fewest
/// stitches to sew, of these the first. `stitches`: [tube] what a seam across it costs, 0 if it cannot
/// be cut. Exact if no more than twelve tubes that go on at both ends can be cut. Of more than twelve
/// one or two are found if they do; otherwise cuts are taken back one by one, the dearest first, as
/// long as the tubes can hang.
SeamChoice choose_seams(const std::vector<TubeLinks>& tubes, const std::vector<int>& stitches);

}  // namespace meshknit
