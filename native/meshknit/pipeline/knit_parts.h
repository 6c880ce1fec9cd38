#pragma once

#include <string>
#include <vector>

#include "meshknit/machine/machine_profile.h"
#include "meshknit/machine/program.h"
#include "meshknit/tracing/stitch.h"

namespace meshknit {

/// A tube of the object as it comes off the machine.
struct KnitPart {
  int tube = 0;
  int line = 0;                 ///< of its first loop, in the file
  int lowest = 0, highest = 0;  ///< needles that it used
  int starts = 0, ends = 0;     ///< loops that begin on waste, and that end under it
  std::vector<int> from, into;  ///< tubes: those that it takes over, those that take it over
  std::vector<std::string> carriers;  ///< in the order of their first use
  int longest_wait = 0;               ///< passes that a loop hung before it was knit through
  int wait_line = 0;                  ///< where that ended
};

/// The parts in the order in which they begin.
/// Requires: a program read from a file of this trace, with lines.
std::vector<KnitPart> find_parts(const Program& program, const StitchTrace& trace,
                                 const MachineProfile& profile);

}  // namespace meshknit
