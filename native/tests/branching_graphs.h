#pragma once

#include "meshknit/knit_graph/knit_graph.h"

namespace meshknit {

/// Hand-drawn knit graphs of several tubes, beside splitting_tube and merging_tube of graphs.h.

/// A trunk of a + b nodes that parts into tubes of a and of b nodes, `rows` rows each, that meet
/// again: a trunk with a hole through it.
KnitGraph tube_with_hole(int a, int b, int rows);

/// A trunk that parts into three legs: first the last c nodes, a row later the others into a and b.
/// In every leg each row but the first has `growth` nodes more than the one below (fewer, if
/// negative).
KnitGraph three_legs(int a, int b, int c, int rows, int growth = 0);

/// A trunk that parts into a tube of `large` nodes and one of a + b1 + c + b2, which parts into three
/// like three_way_split, the middle one first.
KnitGraph three_way_split_beside(int large, int a, int b1, int c, int b2);

/// Three legs knit the other way round, from their hems to the trunk.
KnitGraph three_legs_upside_down(int a, int b, int c, int rows);

/// `arches` arches side by side on a trunk, each of two legs of n nodes that meet again above a third leg
/// between them, which ends before. The trunk's yarn goes on with a leg that meets another.
KnitGraph arches_over_legs(int arches, int n, int rows);

/// `legs` legs of n nodes, side by side, from a trunk that sheds one leg a row.
KnitGraph many_legs(int legs, int n, int rows);

/// A trunk of 4 n nodes that parts twice, into tubes 1, 2, 3 and 4. Tubes 1 and 3 meet, and so do 2
/// and 4, at the same height: whichever pair meets first hangs between the other two, until it
/// ends. If `joined_again`, the two pairs meet in the end, so that neither ends before.
KnitGraph crossed_pairs(int n, int rows, bool joined_again);

}  // namespace meshknit
