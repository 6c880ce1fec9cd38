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
  int lowest_needle = 0, highest_needle = 0;  ///< both 0 without needle operations
  double estimated_minutes = 0.0;             ///< passes * turn + travelled needles / speed
};

/// Counts passes as the machine will make them. Operations join one pass while racking, carriers,
/// direction and kind agree and needles move on strictly in the direction of travel. Transfers join
/// whatever their order, dropping joins in either direction. Releasing the hook is an empty pass (two if
/// the pass before went the same way), taking a carrier out is one.
/// The machine's own extra passes (kickbacks) are not counted.
ProgramCost measure_program(const Program& program, const MachineProfile& profile);

}  // namespace meshknit
