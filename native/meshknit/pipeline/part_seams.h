#pragma once

#include <vector>

#include "meshknit/machine/program.h"
#include "meshknit/pipeline/knit_parts.h"
#include "meshknit/tracing/seams.h"
#include "meshknit/tracing/stitch.h"

namespace meshknit {

/// Which parts a seam joins, and where to begin to sew.
struct PartSeam {
  int lower = 0, upper = 0;  ///< indices into the parts: sewn at its end, at its beginning
  int lower_loops = 0, upper_loops = 0;
  int lower_line = 0, upper_line = 0;  ///< in the file, of two stitches to be sewn together
};

/// Requires: the program's parts, in whose trace every seam is cut.
/// Ensures: a result for each seam, in their order.
std::vector<PartSeam> find_part_seams(const std::vector<Seam>& seams,
                                      const std::vector<KnitPart>& parts,
                                      const Program& program, const StitchTrace& trace);

}  // namespace meshknit
