#pragma once

#include <vector>

#include "meshknit/core/problem.h"
#include "meshknit/core/run_context.h"
#include "meshknit/knit_graph/knit_graph.h"
#include "meshknit/remesh/first_rows.h"
#include "meshknit/surface/surface.h"

namespace meshknit {

/// Measured stitch dimensions (paper, section 4), mm.
struct RemeshOptions {
  double stitch_width = 3.66;   ///< l_r
  double stitch_height = 1.73;  ///< l_c
  bool relax = true;            ///< even edges out afterwards (even_edges.h)
};

/// Surface and knitting time -> knit graph (paper, section 3.2): tube by tube between the saddles
/// of the field (sweep_plan.h), rows are peeled off at geodesic distance 2 l_c from the active
/// cycle, cut to short rows by time, linked and trimmed; whole rows step over the saddles
/// (junction.h); then edges are evened out.
/// Requires: a surface without errors; time per mesh vertex with check_time_field(...) free of
/// errors.
/// Throws: NotKnittable ("too-many-stitches" for sizes that are nearly always a wrong unit,
/// "too-flat" for less than two rows, "splits-here" and "junction-too-tight" for parts too thin for
/// the gauge, with the place); InvalidInput; Cancelled.
/// Ensures: check_knit_graph(result) has no errors. `warnings` (if wanted) says which parts rows
/// could not reach into ("part-left-out"). `first_rows` (if wanted) gets the rows while they are knit.
KnitGraph remesh(const Surface& surface, const std::vector<double>& time,
                 const RemeshOptions& options = {}, RunContext* run = nullptr,
                 Problems* warnings = nullptr, FirstRows* first_rows = nullptr);

}  // namespace meshknit
