#pragma once

#include <string>
#include <vector>

#include "meshknit/machine/machine_profile.h"
#include "meshknit/pipeline/pipeline.h"
#include "meshknit/tracing/seams.h"
#include "meshknit/tracing/stitch.h"

namespace meshknit {

/// What the person at the machine needs to know of a file, as a page of plain text: the machine, what
/// to thread into which carrier, where on the bed and for how long it knits, its parts in the order in
/// which they begin, what to cut, sew, bind off and weave in afterwards, and what to watch. Parts are
/// numbered from 1 in that order; lines are those of the knitout file. No clock, no file names.
/// Requires: a file of this trace with text, check and cost (kcode_sweeps if there is a .kc file); the
/// seams that the traced graph is cut along.
std::string write_run_sheet(const StitchTrace& trace, const CheckedKnitout& file,
                            const MachineProfile& profile, const std::vector<Seam>& seams = {});

}  // namespace meshknit
