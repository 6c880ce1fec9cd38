#include "meshknit/pipeline/pipeline.h"

#include <algorithm>
#include <cmath>

#include "meshknit/core/error.h"
#include "meshknit/knitout/kcode_plan.h"
#include "meshknit/knitout/knitout_writer.h"
#include "meshknit/pipeline/run_sheet.h"
#include "meshknit/pipeline/seam_problems.h"
#include "meshknit/schedule/schedule_checks.h"
#include "meshknit/tracing/trace.h"
#include "meshknit/tracing/trace_checks.h"
#include "meshknit/verify/kcode_check.h"
#include "meshknit/verify/machine_rules.h"

namespace meshknit {
namespace {

// Throws for the first error that a stage's own check found in its result.
void keep_promise(const char* stage, const Problems& problems) {
  for (const Problem& p : problems)
    if (p.severity == Severity::error)
      throw BrokenPromise(std::string(stage) + " failed its own check (" + p.code +
                          "): " + p.message);
}

// Below these parts of edges within 10 % of their length, the knitted shape will differ visibly.
constexpr double good_rows = 0.93, good_columns = 0.85;

void warn_of_poor_fit(CheckedGraph& result) {
  const LengthError &rows = result.stats.row_error, &columns = result.stats.column_error;
  if (rows.within_10 >= good_rows && columns.within_10 >= good_columns) return;
  Problem problem;
  problem.code = "poor-fit";
  problem.severity = Severity::warning;
  problem.message =
      "Only " + std::to_string(std::lround(100.0 * rows.within_10)) +
      " % of the row edges and " + std::to_string(std::lround(100.0 * columns.within_10)) +
      " % of the columns are within 10 % of the stitch's size: the knitted piece will "
      "differ from the model.";
  problem.remedy =
      "Look at the places that are named: smooth details smaller than a few stitches, keep "
      "openings "
      "level with the rows, or choose a finer gauge.";
  const KnitGraph& graph = result.graph;
  for (std::size_t i = 0; i < graph.columns.size(); ++i)
    if (std::abs(graph.column_lengths[i] / (2.0 * graph.stitch_height) - 1.0) > 0.2)
      problem.elements.nodes.push_back(graph.columns[i][1]);
  result.check.problems.push_back(std::move(problem));
}

// A profile's own settings may be wrong where people write it.
void require_settings(const MachineProfile& profile) {
  ProblemLog log;
  for (const std::string& setting : profile.first_settings) {
    Instruction instruction;
    instruction.op = Op::extension;
    instruction.text = setting;
    check_setting(instruction, profile, log);
  }
  if (log.errors() > 0)
    throw InvalidInput("the machine's first settings: " + log.problems().front().message);
}

void add_kcode(const Program& program, const MachineProfile& profile, CheckedKnitout& result) {
  const std::vector<KcodePass> sweeps = plan_kcode(program, profile);
  result.kcode = write_kcode(sweeps, profile.needles);
  result.kcode_sweeps = static_cast<int>(sweeps.size());
  result.cost.estimated_minutes = kcode_minutes(sweeps, profile);
  keep_promise("The .kc file", check_kcode(result.kcode, result.text, profile));
}

}  // namespace

CheckedGraph build_knit_graph(const Surface& surface, const std::vector<double>& time,
                              const RemeshOptions& options, RunContext* run,
                              FirstRows* first_rows) {
  if (has_errors(surface.problems)) throw NotKnittable(surface.problems);
  const TimeFieldCheck field = check_time_field(surface, time);
  if (has_errors(field.problems)) throw NotKnittable(field.problems);
  CheckedGraph result;
  Problems warnings;
  result.graph = remesh(surface, time, options, run, &warnings, first_rows);
  result.check = check_knit_graph(result.graph);
  keep_promise("Remeshing", result.check.problems);
  result.check.problems.insert(result.check.problems.end(), warnings.begin(), warnings.end());
  result.stats = measure_graph(result.graph);
  warn_of_poor_fit(result);
  const std::vector<Seam> seams = plan_seams(result.graph).seams;
  if (!seams.empty()) result.check.problems.push_back(propose_seams(result.graph, seams));
  return result;
}

CheckedGraph cut_seams(CheckedGraph graph) {
  graph.seams = plan_seams(graph.graph).seams;
  if (graph.seams.empty()) return graph;
  graph.graph = cut_along(graph.graph, graph.seams);
  KnitGraphCheck check = check_knit_graph(graph.graph);
  keep_promise("Cutting seams", check.problems);
  Problems& problems = graph.check.problems;
  problems.erase(std::remove_if(problems.begin(), problems.end(),
                                [](const Problem& p) { return p.code == "seam-needed"; }),
                 problems.end());
  const Problems seams = warn_of_seams(graph.graph, graph.seams);
  problems.insert(problems.end(), seams.begin(), seams.end());
  graph.check.violations = check.violations;
  graph.stats = measure_graph(graph.graph);
  return graph;
}

StitchTrace build_trace(const KnitGraph& graph, const MachineProfile& profile,
                        RunContext* run) {
  const int yarns = static_cast<int>(carriers_for_yarn(profile).size());
  StitchTrace trace = trace_knit_graph(graph, std::max(1, yarns), run);
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
                             const MachineProfile& profile, RunContext* run,
                             const std::vector<Seam>& seams) {
  require_settings(profile);
  const Program program = emit_program(trace, schedule, profile, run);
  CheckedKnitout result;
  result.text = write_knitout(program);
  result.check = verify_knitout(result.text, profile, trace, run);
  keep_promise("The machine file", result.check.problems);
  result.cost = measure_program(program, profile);
  if (profile.takes_kcode) add_kcode(program, profile, result);
  result.sheet = write_run_sheet(trace, result, profile, seams);
  return result;
}

}  // namespace meshknit
