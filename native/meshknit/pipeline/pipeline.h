#pragma once

#include <string>
#include <vector>

#include "meshknit/core/run_context.h"
#include "meshknit/emit/emit_program.h"
#include "meshknit/knit_graph/knit_graph_checks.h"
#include "meshknit/machine/carriage_passes.h"
#include "meshknit/machine/machine_profile.h"
#include "meshknit/remesh/remesh.h"
#include "meshknit/schedule/schedule.h"
#include "meshknit/surface/surface.h"
#include "meshknit/time_field/time_field.h"
#include "meshknit/tracing/seams.h"
#include "meshknit/tracing/stitch.h"
#include "meshknit/verify/verify_knitout.h"

namespace meshknit {

// The stages as users run them: each checks its own result before it hands it on, with the same
// checkers that tests call. All throw NotKnittable for the model's faults, BrokenPromise
// (naming the stage and the check) for ours, and Cancelled.

/// `check` also warns where many edges are far from the stitch's size ("poor-fit"), of parts that
/// no row could reach into ("part-left-out"), and of tubes that would have to cross, with the seams
/// that would help ("seam-needed"); after cut_seams of each seam that there is ("seam").
struct CheckedGraph {
  KnitGraph graph;
  KnitGraphCheck check;  ///< without errors
  KnitGraphStats stats;
  std::vector<Seam> seams;  ///< along which the graph is cut
};
CheckedGraph build_knit_graph(const Surface& surface, const std::vector<double>& time,
                              const RemeshOptions& options, RunContext* run = nullptr,
                              FirstRows* first_rows = nullptr);

/// For a user who will sew: the graph with the seams that it needs (tracing/seams.h), as it was if it
/// needs none or none would help.
CheckedGraph cut_seams(CheckedGraph graph);

/// With no more yarns at once than the machine has carriers for, if an order of rows allows that.
StitchTrace build_trace(const KnitGraph& graph, const MachineProfile& profile,
                        RunContext* run = nullptr);

Schedule build_schedule(const StitchTrace& trace, const MachineProfile& profile,
                        RunContext* run = nullptr);

/// A machine file that the simulated machine has knitted and found equal to the trace; for machines
/// that take .kc files that, too, read back and found to make the same loops.
struct CheckedKnitout {
  std::string text;
  std::string kcode;     ///< empty if the machine takes none
  int kcode_sweeps = 0;  ///< of the carriage
  std::string sheet;     ///< for the person at the machine (run_sheet.h)
  VerifyReport check;    ///< ok
  ProgramCost cost;      ///< with a .kc file the minutes are those of all its sweeps
};
/// The sheet tells of the seams that the traced graph is cut along.
/// Throws, too: InvalidInput if the profile begins programs with settings that its machine has not.
CheckedKnitout build_knitout(const StitchTrace& trace, const Schedule& schedule,
                             const MachineProfile& profile, RunContext* run = nullptr,
                             const std::vector<Seam>& seams = {});

}  // namespace meshknit
