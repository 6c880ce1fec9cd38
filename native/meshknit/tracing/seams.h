#pragma once

#include <Eigen/Core>
#include <array>
#include <vector>

#include "meshknit/knit_graph/knit_graph.h"

namespace meshknit {

/// A place where a tube is cut across, to be sewn after knitting: the row below it ends its part of
/// the object, the row above it starts another.
struct Seam {
  int row_below = -1, row_above = -1;  ///< closed rows of the graph
  /// What the seam cuts, and so which nodes are to be sewn to which: all columns between the two rows,
  /// in the graph's order.
  std::vector<std::array<int, 2>> columns;
  Eigen::Vector3d middle = Eigen::Vector3d::Zero();  ///< of its nodes, mm
};

/// What a graph's tubes need to hang side by side without crossing.
struct SeamPlan {
  bool needed = false;      ///< they cannot as they are
  std::vector<Seam> seams;  ///< upwards; empty if none is needed or nothing helps
};

/// Looks whether the tubes can hang on the beds in some order of events (hanging_order.h); if not,
/// the fewest seams that let them (seam_choice.h). A seam lies where its tube is narrowest: between
/// two closed rows without short rows, with the fewest nodes; of these, where most go over one to one,
/// then farthest from where the tube begins and ends.
/// Requires: check_knit_graph(graph) finds no error.
SeamPlan plan_seams(const KnitGraph& graph);

/// The graph without the columns that the seams cut. Nodes and rows keep their numbers.
/// Requires: seams of plan_seams(graph).
/// Ensures: check_knit_graph(result) finds no error, and plan_seams(result) needs none.
KnitGraph cut_along(const KnitGraph& graph, const std::vector<Seam>& seams);

}  // namespace meshknit
