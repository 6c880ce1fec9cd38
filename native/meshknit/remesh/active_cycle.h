#pragma once

#include <vector>

#include "meshknit/remesh/front.h"

namespace meshknit {

/// A node of the active cycle: it waits to be linked.
struct ActiveNode {
  int node = -1;           ///< in the knit graph
  int halfedge = -1;       ///< the crossing before it on the cycle it was sampled on
  int next_halfedge = -1;  ///< and the one after
  double along = 0.0;      ///< fraction of the way between them
  Eigen::Vector3d position;
  double place = 0.0;    ///< distance along the active cycle; kept by place_nodes
  bool single = false;   ///< takes 1-1 links only: a short row ends here or beside it
  bool row_end = false;  ///< a short row ends here
  bool shaped = false;   ///< increased or decreased into
};

/// The most recently knitted cycle, partly knit over by short rows: its nodes from several
/// rows, in order.
struct ActiveCycle {
  Cycle cycle;
  std::vector<ActiveNode> nodes;
};

/// Fills `place` of every node after the cycle has changed. Nodes keep their triangle where the
/// cycle still runs through it; others go to the nearest point.
/// Ensures: places increase strictly round the cycle.
void place_nodes(ActiveCycle& active, std::vector<int>& piece_of_edge);

}  // namespace meshknit
