#pragma once

#include <functional>

#include "meshknit/remesh/patch.h"

namespace meshknit {

/// Adds stitches where edges are stretched: short rows where columns are, wales from an increase to a
/// decrease where rows are. Each is tried: its surroundings are relaxed, and it stays if the errors
/// get smaller by more than its turns or shaping cost. `points` holds the places of the graph's nodes,
/// which should be relaxed. Returns how many rows and wales were added. `progress` as in
/// relaxation.h.
int add_stitches(EditableGraph& graph, SurfaceSprings& points, const StitchSize& size,
                 const std::function<void(double)>& progress = {});

}  // namespace meshknit
