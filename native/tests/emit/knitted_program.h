#pragma once

#include <string>

#include "meshknit/machine/machine_profile.h"
#include "meshknit/tracing/stitch.h"
#include "problem_text.h"

namespace meshknit {

/// The Shima's profile.
const MachineProfile& shima();

/// Schedules, emits and writes a trace for the Shima, and asks the independent check what came out.
std::string errors_of_program(const StitchTrace& trace);

}  // namespace meshknit
