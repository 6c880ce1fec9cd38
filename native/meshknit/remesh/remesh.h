#pragma once

#include <vector>

#include "meshknit/core/run_context.h"
#include "meshknit/knit_graph/knit_graph.h"
#include "meshknit/surface/surface.h"

namespace meshknit {

/// Measured stitch dimensions (paper, section 4), mm.
struct RemeshOptions {
  double stitch_width = 3.66;   ///< l_r
  double stitch_height = 1.73;  ///< l_c
};

/// Surface and knitting time -> knit graph (paper, section 3.2): rows are peeled off at geodesic
/// distance 2 l_c from the active cycle, cut to short rows by time, linked and trimmed, from the
/// early to the late boundary; then node positions are relaxed.
/// Requires: a surface without errors; time per mesh vertex with check_time_field(...) free of errors.
/// Throws: NotKnittable ("needs-one-tube" for surfaces other than one tube, "too-many-stitches" for
/// sizes that are nearly always a wrong unit, "too-flat" for less than two rows, and reasons that name the place); InvalidInput; Cancelled.
/// Ensures: check_knit_graph(result) has no errors.
KnitGraph remesh(const Surface& surface, const std::vector<double>& time,
                 const RemeshOptions& options = {}, RunContext* run = nullptr);

}  // namespace meshknit
