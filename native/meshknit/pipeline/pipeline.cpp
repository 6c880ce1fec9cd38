#include "meshknit/pipeline/pipeline.h"

#include "meshknit/core/error.h"
#include "meshknit/knitout/knitout_writer.h"
#include "meshknit/schedule/schedule_checks.h"
#include "meshknit/tracing/trace.h"
#include "meshknit/tracing/trace_checks.h"

namespace meshknit {
namespace {

// Throws for the first error that a stage's own check found in its result.
void keep_promise(const char* stage, const Problems& problems) {
  for (const Problem& p : problems)
    if (p.severity == Severity::error)
      throw BrokenPromise(std::string(stage) + " failed its own check (" + p.code +
                          "): " + p.message);
}

}  // namespace

CheckedGraph build_knit_graph(const Surface& surface, const std::vector<double>& time,
                              const RemeshOptions& options, RunContext* run) {
  if (has_errors(surface.problems)) throw NotKnittable(surface.problems);
  const TimeFieldCheck field = check_time_field(surface, time);
  if (has_errors(field.problems)) throw NotKnittable(field.problems);
  CheckedGraph result;
  result.graph = remesh(surface, time, options, run);
  result.check = check_knit_graph(result.graph);
  keep_promise("Remeshing", result.check.problems);
  result.stats = measure_graph(result.graph);
  return result;
}

StitchTrace build_trace(const KnitGraph& graph, RunContext* run) {
  StitchTrace trace = trace_knit_graph(graph, run);
  keep_promise("Tracing", check_trace(graph, trace));
  return trace;
}

Schedule build_schedule(const StitchTrace& trace, const MachineProfile& profile,
                        RunContext* run) {
  Schedule schedule = schedule_stitches(trace, profile, run);
  keep_promise("Scheduling", check_schedule(trace, schedule, profile));
  return schedule;
}

CheckedKnitout build_knitout(const StitchTrace& trace, const Schedule& schedule,
                             const MachineProfile& profile, RunContext* run) {
  const Program program = emit_program(trace, schedule, profile, run);
  CheckedKnitout result;
  result.text = write_knitout(program);
  result.check = verify_knitout(result.text, profile, trace, run);
  keep_promise("The machine file", result.check.problems);
  result.cost = measure_program(program, profile);
  return result;
}

}  // namespace meshknit
