#pragma once

#include <vector>

#include "meshknit/remesh/patch.h"

namespace meshknit {

/// The edge after a node in its row, or the first one up its column.
enum class EdgeKind { row, column };

struct StretchedEdge {
  int node = -1;
  EdgeKind kind = EdgeKind::row;
  double error = 0.0;  ///< (length - wanted) / wanted
};

/// Says where edges are too long. `points` holds the places of the graph's nodes; both may change.
class Stretch {
 public:
  Stretch(const EditableGraph& graph, const SurfaceSprings& points, const StitchSize& size)
      : graph_(graph), points_(points), size_(size) {}

  /// Node along the edge, and back from this node along its own kind of edge; -1 if there is none.
  int after(int node, EdgeKind kind) const;
  int before(int node, EdgeKind kind) const;

  /// Relative error of the edge after the node; -1 if there is none.
  double error(int node, EdgeKind kind) const;

  /// How much of a stitch is missing at this edge and the few before and after it, which relaxation
  /// has shared the lack out to.
  double lack(int node, EdgeKind kind) const;

  /// All edges with a greater error than this, the worst first.
  std::vector<StretchedEdge> edges(double least_error) const;

 private:
  const EditableGraph& graph_;
  const SurfaceSprings& points_;
  StitchSize size_;
};

}  // namespace meshknit
