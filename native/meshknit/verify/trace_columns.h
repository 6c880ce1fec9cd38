#pragma once

#include <array>
#include <vector>

#include "meshknit/tracing/stitch.h"
#include "meshknit/verify/expected_loops.h"

namespace meshknit {

/// Where tubes part or meet. A ring of columns a .. b | c .. a falls into two, or two rings become
/// one, when `second` becomes the anticlockwise neighbour of `first`, and the column that came
/// before `second` that of the column that came after `first`:
///
///     one tube     first > x .. y > second ..     x and y become neighbours, and so do
///     two tubes    first > x ..,  y > second ..   first and second
///
/// The same exchange parts what is one ring and joins what are two.
struct Junction {
  int first = -1, second = -1;  ///< columns
  int opens = -1;               ///< stitch after which no yarn uses the old neighbours
  int stitch = -1;              ///< its yarn comes from one of them and knits the other
};

/// The columns of a trace: a column is a place round a tube, with one loop after another. Starts
/// and second loops of increases begin columns, a decrease ends one. Everything is read off the
/// trace: yarn steps from a column to its neighbour, and where it steps to another one than the
/// ring has there, tubes part or meet (paper, section 3.4).
struct TraceColumns {
  int columns = 0;
  std::vector<std::array<int, 2>> of;  ///< stitch, which loop -> column, -1 for none
  std::vector<int> cast_on;            ///< start stitch -> its round of starts; -1 for others
  std::vector<Junction> junctions;     ///< ordered by `stitch`
};

/// Requires: check_trace_form.
TraceColumns find_trace_columns(const StitchTrace& trace);

}  // namespace meshknit
