#pragma once

#include <vector>

#include "meshknit/tracing/stitch.h"
#include "meshknit/verify/problem_log.h"

namespace meshknit {

/// A loop that the trace promises: `which` is 1 for the second loop of an increase, else 0.
struct ExpectedLoop {
  int stitch = -1;
  int which = 0;
  friend bool operator==(const ExpectedLoop& a, const ExpectedLoop& b) {
    return a.stitch == b.stitch && a.which == b.which;
  }
};

/// True if the trace can be compared with: indices in range, parents and children agree, and
/// every kind has its number of each. Says what is wrong otherwise ("bad-trace").
bool check_trace_form(const StitchTrace& trace, ProblemLog& log);

/// The loops of every yarn in the order of their making.
/// Requires: check_trace_form.
std::vector<std::vector<ExpectedLoop>> expected_yarns(const StitchTrace& trace);

/// The loops that a stitch goes through, in the order of the trace's parents. Both loops of one
/// increase below one stitch: that stitch meets the knit first if it runs the same way,
/// otherwise the second loop.
/// Requires: check_trace_form.
std::vector<ExpectedLoop> expected_parents(const StitchTrace& trace, int stitch);

}  // namespace meshknit
