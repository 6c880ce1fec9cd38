#pragma once

#include <string>
#include <vector>

#include "meshknit/machine/machine_profile.h"
#include "meshknit/tracing/stitch.h"

namespace meshknit {

/// Which carrier brings a yarn, and for how long.
struct YarnUse {
  std::string carrier;
  int first_stitch = -1, last_stitch = -1;
};

/// A carrier for every yarn of a trace. From profile.yarn_carrier on, the waste's left out, the
/// first that is free is taken; it is free again after its yarn's last stitch.
/// Throws: NotKnittable "too-many-carriers" if more yarns are in use at a time than the machine has
/// carriers for; names the stitches of all of them and their nodes.
std::vector<YarnUse> assign_carriers(const StitchTrace& trace, const MachineProfile& profile);

}  // namespace meshknit
