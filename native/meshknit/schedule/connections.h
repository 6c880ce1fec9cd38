#pragma once

#include <vector>

#include "meshknit/schedule/bed_layout.h"
#include "meshknit/schedule/tube_steps.h"

namespace meshknit {

/// Where one tube becomes several, or several become one, which hang side by side: the loops of the
/// outer parts in one piece each, those of a part between others in two, across from each other
/// (paper, appendix A), make up the ring of the whole.
struct Connection {
  bool split = false;      ///< else a merge
  int whole = 0;           ///< tube
  std::vector<int> parts;  ///< tubes, as they hang from one side to the other
  int first = 0;           ///< of a split: the part that is knit first
  /// The ring of the whole, anticlockwise, beginning with the loops of parts[0]: slots of the whole
  /// (the stacks of a split's last ring, or of a merge's first).
  std::vector<int> whole_slots;
  /// [part] the slots in their part of the same loops, in the same order: a part between others has
  /// those that come on the way from parts[0] first.
  std::vector<std::vector<int>> part_slots;
  std::vector<int> ends;  ///< aligned_ends (knit_graph/ring_parts.h) of the parts
};

/// All connections of an object, in the order of the first steps above them.
/// Throws: NotKnittable "tubes-not-side-by-side" if tubes part or meet otherwise than one into some or
/// some into one, or the loops of the parts do not lie as above, with as many on one bed as on the
/// other. Names stitches and nodes.
std::vector<Connection> find_connections(const StitchTrace& trace, const SteppedTubes& tubes);

/// Layouts that a connection's loops may have: one layout of the whole that is, at the same time,
/// one layout of each part, hanging side by side (paper, Property 6). The place of the whole is 0.
struct ConnectionLayout {
  BedLayout whole;
  std::vector<BedLayout> parts;
};

/// The layout with parts[0] at the left (`left` 0) or at the right (1), where the order is turned
/// round:
///
///     back     x4 x3 y5 y4 y3
///     front    x0 x1 x2 y0 y1 y2        whole: x0 x1 x2 y0 ... y5 x3 x4
///
/// An even cycle is aligned, an odd one has its back bed flush with the front or one place further
/// left, at both ends: such yarn bridges bear all rackings (longest_bridge, bed_layout.h).
ConnectionLayout connection_layout(const Connection& connection, int left);

}  // namespace meshknit
