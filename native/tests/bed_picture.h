#pragma once

#include <string>

#include "meshknit/tracing/stitch.h"

namespace meshknit {

/// A trace as text, for readable failures: a line for every run of stitches in one direction by
/// one yarn, with stitch number, kind and node, and behind '^' the stitches it is knit through.
///
///     yarn 0  ->  8 knit@0^0  9 increase@1^1  10 tuck@2
std::string bed_picture(const StitchTrace& trace);

}  // namespace meshknit
