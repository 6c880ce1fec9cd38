#pragma once

#include <vector>

#include "meshknit/knitout/kcode.h"
#include "meshknit/machine/machine_profile.h"
#include "meshknit/machine/program.h"

namespace meshknit {

/// A program as sweeps of the Kniterate's carriage: those of carriage_passes, and those between them
/// that bring a carrier to the side from which it is wanted, move waiting carriers out of the way of
/// needles at work, take carriers out, or bring the carriage back.
/// Requires: a profile that takes_kcode.
/// Throws: InvalidInput for what such files cannot say: splits, sliders, several carriers in a loop,
/// pauses, carriers that the profile does not have, needles off the bed, settings that are no numbers.
/// Ensures: directions alternate, beginning rightward; check_kcode (verify/kcode_check.h) finds the
/// same loops as in the program.
std::vector<KcodePass> plan_kcode(const Program& program, const MachineProfile& profile);

/// How long the machine takes for them, by the profile's constants.
double kcode_minutes(const std::vector<KcodePass>& sweeps, const MachineProfile& profile);

}  // namespace meshknit
