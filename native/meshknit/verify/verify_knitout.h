#pragma once

#include <string_view>

#include "meshknit/core/problem.h"
#include "meshknit/core/run_context.h"
#include "meshknit/machine/machine_profile.h"
#include "meshknit/tracing/stitch.h"

namespace meshknit {

/// What the simulated machine saw.
struct VerifyReport {
  bool ok = false;    ///< no errors: the file may leave
  Problems problems;  ///< each names its line and, where there is one, its stitch
  int loops = 0;      ///< loops of the object (waste and anchors not counted)
  int edges = 0;      ///< loop-through-loop edges of the object
  int errors = 0, warnings = 0;
  int max_stack = 0;
  int max_stretch = 0;  ///< needles
};

/// The independent check (primer, section 7). Replays the text on a model of both beds,
/// rebuilds every loop with its parents and yarn and compares, carrier by carrier and item by
/// item, with the trace. Looks at nothing but its three arguments. Never throws on any text
/// (but Cancelled).
///
/// Any number of tubes may hang at once, begin and end at any time, part and meet; the trace alone
/// says which loops make a tube (verify/tube_check.h).
///
/// What it takes for granted beyond the primer:
///  - one carrier a loop; any number of yarns, in the trace's order of first loops;
///  - stitches are made while their tube lies flat (verify/tube_order.h), anchors not counted;
///    other tubes may be parked meanwhile;
///  - tubes that lie opposite each other for a while go back to their sides (verify/tube_places.h);
///  - a tuck on the other bed than the loop before it may be made before or after the turn;
///  - an end stitch's loop is knit through by waste, or dropped after its yarn went out; waste
///    above it is dropped after the waste's yarn went out;
///  - yarn to a loop that is gone counts from the needle where that loop last hung.
VerifyReport verify_knitout(std::string_view text, const MachineProfile& profile,
                            const StitchTrace& trace, RunContext* run = nullptr);

}  // namespace meshknit
