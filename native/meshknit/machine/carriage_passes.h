#pragma once

#include "meshknit/machine/machine_profile.h"
#include "meshknit/machine/program.h"

namespace meshknit {

/// What a program costs the machine.
struct ProgramCost {
  int operations = 0;  ///< needle operations
  int passes = 0;      ///< carriage passes, by the rules of the primer's section 2.6
  int transfers = 0;
  double max_racking = 0.0;
  int lowest_needle = 0, highest_needle = 0;
  double estimated_minutes = 0.0;
};
ProgramCost measure_program(const Program& program, const MachineProfile& profile);

}  // namespace meshknit
