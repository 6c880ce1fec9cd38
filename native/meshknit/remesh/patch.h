#pragma once

#include <vector>

#include "meshknit/knit_graph/editable_graph.h"
#include "meshknit/remesh/surface_springs.h"

namespace meshknit {

/// Wanted lengths of edges, mm.
struct StitchSize {
  double width = 3.66;   ///< l_r
  double height = 3.46;  ///< 2 l_c
};

/// The nodes of a graph within a few steps from some place, to be relaxed while all others stay.
class Patch {
 public:
  Patch(const EditableGraph& graph, SurfaceSprings& points, const StitchSize& size)
      : graph_(graph), points_(points), size_(size) {}

  /// Begins anew with the nodes near these.
  void gather(const std::vector<int>& centre);
  /// Adds nodes that are new.
  void include(const std::vector<int>& added);

  /// Sum of the squared relative errors of all edges at the patch's nodes.
  double error() const;
  /// Relaxes the patch, but for first and last rows, which lie on boundaries.
  void relax();
  /// Puts the nodes back to where they were when they were gathered.
  /// Requires: included nodes are no longer in the graph.
  void restore();

  const std::vector<int>& nodes() const { return nodes_; }

 private:
  void find_springs();
  void put(int node);
  bool has(int node) const {
    return node < static_cast<int>(place_.size()) && place_[node] >= 0;
  }

  const EditableGraph& graph_;
  SurfaceSprings& points_;
  StitchSize size_;
  std::vector<int> nodes_;
  std::vector<int> place_;  // per node of the graph: its place in nodes_, or -1
  std::vector<FacePoint> before_;
  std::vector<Spring> springs_;
};

}  // namespace meshknit
