#pragma once

#include <optional>
#include <string>
#include <vector>

#include "meshknit/machine/machine_profile.h"
#include "meshknit/machine/program.h"

namespace meshknit {

/// True for operations of needles; the others move carriers, the racking or nothing.
bool is_needle_operation(Op op);

/// One sweep of the carriage over both beds.
struct CarriagePass {
  enum class Kind {
    yarn,           ///< knits, tucks and misses with a carrier; drops and a-misses without
    front_to_back,  ///< transfers, or splits if there are carriers
    back_to_front,
    release,   ///< of the inserting hook: an empty pass
    carry_out  ///< takes carriers away: an empty pass
  };
  Kind kind = Kind::yarn;
  std::vector<std::string> carriers;
  std::optional<Side> travel;  ///< none: either way will do
  double racking = 0.0;
  int lowest = 0, highest = 0;    ///< front needles that the operations lie opposite
  std::vector<int> instructions;  ///< indices into the program, in its order
};

/// Groups a program into passes as the machine will make them (primer, section 2.6). Operations join
/// one pass while racking, carriers, direction and kind agree and needles move on strictly in the
/// direction of travel. Transfers join whatever their order, dropping joins in either direction;
/// what cannot share a pass otherwise the profile says. Releasing the hook is an empty pass (two if
/// the pass before went the same way), taking a carrier out is one. The machine's own extra passes
/// (kickbacks) are not among them.
std::vector<CarriagePass> carriage_passes(const Program& program,
                                          const MachineProfile& profile);

/// What a program costs the machine.
struct ProgramCost {
  int operations = 0;  ///< needle operations
  int passes = 0;      ///< carriage_passes
  int transfers = 0;
  double max_racking = 0.0;
  std::vector<std::string> carriers;          ///< that make loops, in the machine's order
  int lowest_needle = 0, highest_needle = 0;  ///< both 0 without needle operations
  double estimated_minutes = 0.0;             ///< passes * turn + travelled needles / speed
};

ProgramCost measure_program(const Program& program, const MachineProfile& profile);

}  // namespace meshknit
