#pragma once

#include <vector>

#include "meshknit/tracing/stitch.h"
#include "meshknit/verify/expected_loops.h"
#include "meshknit/verify/fabric.h"
#include "meshknit/verify/problem_log.h"

namespace meshknit {

/// Holds the replayed fabric to the trace (primer, section 7, step 5). The loops of a carrier
/// follow one another, so no matching is needed: yarn by yarn, in the order in which yarns
/// first make a loop of the object, its loops without waste and anchors must be those of the
/// trace, item by item, with the same kinds, directions, parents and stack orders. Comments
/// decide what is waste and name things; a comment that names another stitch than the one whose
/// turn it is, or none, is an error too.
///
/// Returns the traced loop of every loop, without a stitch for those that have none.
/// Requires: check_trace_form.
std::vector<ExpectedLoop> compare_with_trace(const Fabric& fabric, const StitchTrace& trace,
                                             ProblemLog& log);

}  // namespace meshknit
