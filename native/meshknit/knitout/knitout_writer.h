#pragma once

#include <string>

#include "meshknit/machine/program.h"

namespace meshknit {

/// Program -> knitout text, in the style that every known reader accepts (primer, section 2.5).
/// Ensures: read_knitout(result) gives the program back; the same program gives the same bytes.
std::string write_knitout(const Program& program);

}  // namespace meshknit
