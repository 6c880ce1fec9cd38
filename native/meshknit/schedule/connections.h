#pragma once

#include <array>
#include <vector>

#include "meshknit/schedule/bed_layout.h"
#include "meshknit/schedule/tube_steps.h"

namespace meshknit {

/// Where one tube becomes two, or two become one. The loops of both parts, each part in one piece,
/// make up the ring of the whole.
struct Connection {
  bool split = false;  ///< else a merge
  int whole = 0;       ///< tube
  std::array<int, 2> parts{};
  /// The ring of the whole, anticlockwise, beginning with the loops of parts[0]: slots of the whole
  /// (the stacks of a split's last ring, or of a merge's first), and the slot of each in its part.
  std::vector<int> whole_slots;
  std::array<std::vector<int>, 2> part_slots;
};

/// All connections of an object, in the order of the first steps above them.
/// Throws: NotKnittable "tubes-not-in-pairs" if tubes part or meet otherwise than one into two or
/// two into one; "loops-apart" if the loops of a part are not in one piece. Both name stitches and
/// nodes.
std::vector<Connection> find_connections(const StitchTrace& trace, const SteppedTubes& tubes);

/// Layouts that a connection's loops may have: one layout of the whole that is, at the same time,
/// one layout of each part, hanging side by side (paper, Property 6). The place of the whole is 0.
struct ConnectionLayout {
  BedLayout whole;
  std::array<BedLayout, 2> parts;
};

/// The layout with parts[left] at the left:
///
///     back     x4 x3 y5 y4 y3
///     front    x0 x1 x2 y0 y1 y2        whole: x0 x1 x2 y0 ... y5 x3 x4
///
/// An even cycle is aligned, an odd one has its back bed flush with the front or one place further
/// left, at both ends: such yarn bridges bear all rackings (layout_search.h).
ConnectionLayout connection_layout(const Connection& connection, int left);

}  // namespace meshknit
