#pragma once

#include <string>

#include "meshknit/core/problem.h"
#include "meshknit/machine/machine_profile.h"
#include "meshknit/tracing/stitch.h"

namespace meshknit {

/// The Shima's profile.
const MachineProfile& shima();

/// Codes and messages of the errors among problems, a line each.
std::string errors_of(const Problems& problems);

/// Schedules, emits and writes a trace for the Shima, and asks the independent check what came out.
std::string errors_of_program(const StitchTrace& trace);

}  // namespace meshknit
