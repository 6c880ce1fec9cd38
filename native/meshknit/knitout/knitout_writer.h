#pragma once

#include <string>

#include "meshknit/machine/program.h"

namespace meshknit {

/// Program -> knitout text, in the style that every known reader accepts (primer, section 2.5):
/// one space between words, no tabs, "rack 1" without a plus, no racking that is already in
/// force.
/// Throws: InvalidInput, naming the instruction, for what knitout or its readers cannot take:
/// needle numbers below 1, carrier and header names with separators in them, carriers that are
/// not in the program's list, no carriers at all, extensions that are not one "x-..." or
/// "stitch L T" line, rackings out of range, source stitches below 0.
/// Ensures: read_knitout(result) gives the program back without an error, but for rackings
/// already in force, carrierless operations under their other name, and `line`; the same
/// program gives the same bytes.
std::string write_knitout(const Program& program);

}  // namespace meshknit
