#pragma once

#include <string>
#include <vector>

#include "meshknit/core/problem.h"
#include "meshknit/knit_graph/knit_graph.h"
#include "meshknit/tracing/seams.h"

namespace meshknit {

/// Where a seam runs, for people: "(12, -3, 40) mm".
std::string place_of(const Seam& seam);

/// How many stitches it joins, for people: "24 stitches", or "24 and 26 stitches" if rows differ.
std::string stitches_of(const KnitGraph& graph, const Seam& seam);

/// The warning "seam-needed": which seams would make the object knittable. Names the nodes beside them.
/// Requires: at least one seam of plan_seams(graph).
Problem propose_seams(const KnitGraph& graph, const std::vector<Seam>& seams);

/// One warning "seam" each: what is to be sewn. Names the nodes beside the seam.
Problems warn_of_seams(const KnitGraph& graph, const std::vector<Seam>& seams);

}  // namespace meshknit
