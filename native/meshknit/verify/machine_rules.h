#pragma once

#include "meshknit/machine/machine_profile.h"
#include "meshknit/machine/program.h"
#include "meshknit/verify/beds.h"
#include "meshknit/verify/problem_log.h"

namespace meshknit {

/// Carriers, machine and gauge named in the headers are those of the profile.
void check_headers(const Program& program, const MachineProfile& profile, ProblemLog& log);

/// A racking that the machine can do (a warning if it does not like it), in quarter needles (the nearest one if it cannot).
int check_racking(const Instruction& i, const MachineProfile& profile, ProblemLog& log);

/// A setting (an x- operation) that the machine has, with a value in its range. Others change nothing:
/// a warning.
void check_setting(const Instruction& i, const MachineProfile& profile, ProblemLog& log);

/// The needle exists. False if not: the operation cannot be replayed.
bool check_needle(const Needle& needle, int line, const BedRange& beds,
                  const MachineProfile& profile, ProblemLog& log);

/// From needle to needle of opposite beds that face each other at `racking` (quarter needles),
/// not between two sliders.
void check_handover(const Instruction& i, int racking, ProblemLog& log);

}  // namespace meshknit
