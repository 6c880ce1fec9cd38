#pragma once

#include "meshknit/tracing/trace_state.h"

namespace meshknit {

/// The tracing rules of the paper's section 3.3, one function each, with the paper's names and
/// numbers. A rule that applies makes its stitches and returns true; otherwise it changes
/// nothing. They are to be tried in order.
///
/// Three readings of ours. At a split no branch is begun before the row below it is complete, so
/// that one yarn finishes the row and goes on with the branch above its end, and no other yarn is
/// brought in for the rest of the row. "The current stitch's neighbour" and "the parent's row-wise next
/// node", on which a short row is tucked, are the loop that hangs ahead of the current stitch
/// at that moment: where both exist they are the same, and the loop also exists where the
/// parent itself ends a short row. And a stitch that makes two loops goes on above the one that
/// lies ahead.

/// Rule 1. Begins a yarn in a ready row that no yarn has begun, at its first node.
void start_yarn(TraceState& state, int row);

/// The row that rule 2 would go on to; -1 if the rule does not apply.
int row_to_move_to(const TraceState& state);

/// Rule 2. After a node's second stitch, with a ready row above: knits the neighbour of the
/// node above; if there is none, tucks and knits the node above in reverse.
bool move_to_next_row(TraceState& state);

/// Rule 3. Knits the next node along the row unless it is knit twice.
bool continue_row(TraceState& state);

/// Rule 4. At the end of a short row, at a node that is knit once: tucks and knits it again in
/// reverse.
bool tuck_and_turn(TraceState& state);

/// Rule 5. At the end of a short row that is knit there and back: goes on off its end with the
/// stitch that is due there. That is the second stitch of the row below; or, if that row is a
/// short row over the place where the closed row's yarn ends, which is begun in its middle, it
/// can be the first stitch of a node on its way back.
bool end_short_row(TraceState& state);

/// Rule 6. Nothing else applied: the yarn ends.
void end_yarn(TraceState& state);

}  // namespace meshknit
