#include "meshknit/verify/verify_knitout.h"

#include <vector>

#include "meshknit/knitout/knitout_reader.h"
#include "meshknit/verify/compare_trace.h"
#include "meshknit/verify/expected_loops.h"
#include "meshknit/verify/loop_fates.h"
#include "meshknit/verify/machine_rules.h"
#include "meshknit/verify/problem_log.h"
#include "meshknit/verify/replay.h"
#include "meshknit/verify/tube_check.h"
#include "meshknit/verify/waste_rules.h"

namespace meshknit {
namespace {

void count_loops(const Fabric& fabric, VerifyReport& result) {
  for (const Loop& loop : fabric.loops) {
    if (!is_object(loop)) continue;
    ++result.loops;
    for (int k = loop.first_parent; k < loop.first_parent + loop.parents; ++k) {
      if (is_object(fabric.loops[fabric.parents[k]])) ++result.edges;
    }
  }
  result.max_stack = fabric.max_stack;
  result.max_stretch = (fabric.max_stretch + kQuarters - 1) / kQuarters;
}

}  // namespace

VerifyReport verify_knitout(std::string_view text, const MachineProfile& profile,
                            const StitchTrace& trace, RunContext* run) {
  ProblemLog log;
  const KnitoutText read = read_knitout(text);
  log.take(read.problems);
  check_headers(read.program, profile, log);
  const Fabric fabric = replay_program(read.program, profile, log, run);
  if (check_trace_form(trace, log)) {
    const std::vector<ExpectedLoop> items = compare_with_trace(fabric, trace, log);
    check_loop_fates(fabric, trace, items, log);
    check_waste_below(fabric, trace, items, profile, log);
    check_tubes(read.program, profile, fabric, trace, items, log, run);
  } else {
    check_tubes(read.program, profile, fabric, StitchTrace(), {}, log, run);
  }
  VerifyReport result;
  count_loops(fabric, result);
  result.problems = log.problems();
  result.errors = log.errors();
  result.warnings = log.warnings();
  result.ok = result.errors == 0;
  report(run, 1.0);
  return result;
}

}  // namespace meshknit
