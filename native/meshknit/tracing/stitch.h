#pragma once

#include <vector>

namespace meshknit {

enum class StitchKind {
  start,     ///< no parents: the object begins here (knit on waste)
  knit,      ///< one loop through one loop
  increase,  ///< two children: makes two loops, a knit and then a reverse tuck ahead of it
  decrease,  ///< two parents (not counting tucks)
  tuck,      ///< lies on a neighbour's loop at the end of a short row
  end        ///< no children: the object ends here
};

/// The kind's name in the stitches file: "start", "knit", ...
const char* name_of(StitchKind kind);

/// Seen from above the beds. Clockwise runs leftward along the front bed and rightward along
/// the back; anticlockwise is the yarn order of the knit graph's rows.
///
///        back   b0  b1  b2  b3       anticlockwise:  <- <- <- <-
///        front  f0  f1  f2  f3                       -> -> -> ->
enum class Direction { clockwise, anticlockwise };

/// One stitch of the trace. `parents` and `children` are indices into the trace, in loop order:
/// the order in which this stitch's own direction meets them. They agree with each other: s is
/// a child of p once for every time p is a parent of s. A tuck has no parents; its child is the
/// stitch that knits through it, which names the tuck among its parents right after the stitch
/// whose loop it lies on. A node with two column edges down is decreased in its first stitch,
/// one with two up is increased in its second. A start stitch that is also more (first stitches
/// never are) does not occur; a second stitch without columns up is `end`. A stitch that both
/// decreases and has two children does not occur (the two stitches of a node share the work).
struct Stitch {
  int yarn = 0;
  int tube = 0;  ///< the tube that it is knit on (tubes.h)
  StitchKind kind = StitchKind::knit;
  Direction direction = Direction::anticlockwise;
  int node = -1;  ///< knit graph node; for a tuck the node whose loop it lies on
  std::vector<int> parents;
  std::vector<int> children;
};

/// The traced stitches in construction order (paper, section 3.3): what the machine program is
/// held to.
struct StitchTrace {
  std::vector<Stitch> stitches;
  int yarns = 0;
  int tubes = 1;
  int courses = 0;  ///< knit rows: every graph row counts two
};

}  // namespace meshknit
