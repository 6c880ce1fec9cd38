#pragma once

#include <vector>

#include "meshknit/surface/triangle_mesh.h"

namespace meshknit {

/// Edges as rows of two vertices.
using EdgeArray = Eigen::Matrix<int, Eigen::Dynamic, 2, Eigen::RowMajor>;

/// The edges of a mesh with polygons of any size, for shortest paths along them while a person
/// drags. Paths run to the goal as an A* search does, with straight distances, so they cost what
/// lies between the ends rather than what the mesh has.
class EdgeGraph {
 public:
  /// Lengths have the unit of the positions. Edges with an end that is not finite are no way.
  /// Throws: InvalidInput for an edge whose vertex is not there.
  EdgeGraph(const VertexArray& positions, const EdgeArray& edges);

  /// Vertices of a shortest path, both ends included; {from} if they are one; empty if no edges
  /// lead from one to the other. Deterministic: of ways equally long, each vertex is reached
  /// from the lowest. Keeps working memory between calls: one thread at a time.
  /// Throws: InvalidInput for a vertex that is not there.
  std::vector<int> path(int from, int to);

  /// The rows of the edges along a chain, one fewer than its vertices.
  /// Throws: InvalidInput where two neighbours share no edge.
  std::vector<int> edges_along(const std::vector<int>& chain) const;

 private:
  struct Way {
    int to, edge;
    double length;
  };

  void search(int from, int to);
  void require_vertex(int v) const;

  VertexArray positions_;
  std::vector<std::size_t> first_;  // of each vertex's ways, and the end of the last
  std::vector<Way> ways_;
  std::vector<double> distance_;
  std::vector<int> previous_, touched_;
};

}  // namespace meshknit
