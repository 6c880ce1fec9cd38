#pragma once

#include <string_view>

#include "meshknit/core/problem.h"
#include "meshknit/machine/program.h"

namespace meshknit {

/// What reading gave: the program as far as lines could be understood, and a problem with its
/// line for every other line.
struct KnitoutText {
  Program program;
  Problems problems;
};

/// Knitout text -> program, with syntax checks (primer, section 2). Never throws on any text.
/// Unknown x- operations and X- headers are warnings. Operations without a carrier are named by
/// what they do: knit -> drop, tuck -> amiss, split -> xfer. Comments are lost but for their
/// `!source:`.
KnitoutText read_knitout(std::string_view text);

}  // namespace meshknit
