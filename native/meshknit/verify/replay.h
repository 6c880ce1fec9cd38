#pragma once

#include "meshknit/core/run_context.h"
#include "meshknit/machine/machine_profile.h"
#include "meshknit/machine/program.h"
#include "meshknit/verify/fabric.h"
#include "meshknit/verify/problem_log.h"

namespace meshknit {

/// Runs a program on a model of both beds (primer, sections 2.2 to 2.4 and 7, steps 2 and 3,
/// and the distances of step 6)
/// and returns every loop that it made. What breaks a rule of the machine, stretches yarn, or
/// leaves loops or carriers behind goes to `log` with its line; the replay then goes on as well as
/// it can. Knows nothing of tubes.
/// Reports the first half of the run. Throws: Cancelled.
Fabric replay_program(const Program& program, const MachineProfile& profile, ProblemLog& log,
                      RunContext* run = nullptr);

}  // namespace meshknit
