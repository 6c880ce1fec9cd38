#pragma once

#include <vector>

#include "meshknit/knit_graph/knit_graph.h"
#include "meshknit/tracing/stitch.h"

namespace meshknit {

/// The two stitches of every node, tucks aside.
struct KnitTwice {
  std::vector<int> first, second;  ///< [node]
};

/// Requires: every node is knit exactly twice.
KnitTwice find_stitches(const KnitGraph& graph, const StitchTrace& trace);

/// The parents of a stitch without the tucks among them.
std::vector<int> loop_parents(const StitchTrace& trace, int stitch);

}  // namespace meshknit
