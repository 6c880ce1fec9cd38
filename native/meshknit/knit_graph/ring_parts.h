#pragma once

#include <vector>

namespace meshknit {

/// A stretch of a ring that goes to one part: `count` elements from `first` on.
struct PartStretch {
  int part = 0, first = 0, count = 0;
};

/// The stretches round a ring: `part` tells for each of its elements, in their order, which part it
/// goes to.
std::vector<PartStretch> ring_stretches(const std::vector<int>& part);

/// How the parts of a ring of loops hang side by side on two beds, where tubes part or meet (paper,
/// appendix A): the part at the left and the one at the right have one stretch each, all others two,
/// across from each other. Listed round the ring from the left part on: A B C ... K ... C B, with
/// the end part of the lower number at the left.
/// Empty if there is one part only or they do not lie so.
std::vector<PartStretch> ring_parts(const std::vector<int>& part);

/// Where the beds' ends lie at the borders of tubes side by side, from the left end of the first to
/// the right end of the last: by how many places the back bed's end is right of the front's. Even
/// tubes, and the whole if it is even, are aligned (0 at both ends); an odd one has a 0 at one end
/// and a -1 at the other, so that one loop more hangs on one of the beds. Such yarn bridges bear all
/// rackings.
/// `sizes`: loops of each tube; `left`: the first end, 0 or -1. Empty if these sizes do not hang so.
std::vector<int> aligned_ends(const std::vector<int>& sizes, int left);

}  // namespace meshknit
