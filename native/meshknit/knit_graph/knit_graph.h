#pragma once

#include <Eigen/Core>
#include <array>
#include <vector>

namespace meshknit {

/// A point of the surface where two stacked stitches will be made (paper, section 3.2).
struct KnitNode {
  Eigen::Vector3d position;  ///< mm, on the surface
  double time = 0.0;         ///< knitting time there, -1 (first) to 1 (last)
};

/// A row: nodes in yarn order. Row edges join neighbours; a closed row (a cycle) also joins its
/// last node to its first; an open one is a short row. The surface that is knit later lies to
/// the left of the row, seen with the mesh normals pointing up: on the machine that is
/// anticlockwise, seen from above the beds.
struct KnitRow {
  std::vector<int> nodes;
  bool closed = true;
};

/// The knit graph (N, R, C) of the paper. Every node is in exactly one row. Columns are ordered
/// by `from`, then by the order of their `to` nodes along the row (a closed row's last node
/// comes before its first, if an increase has these two above it). Rows are in the order in
/// which they were made, so every column goes from an earlier row to a later one.
struct KnitGraph {
  double stitch_width = 3.66;   ///< l_r, mm: wanted length of a row edge
  double stitch_height = 1.73;  ///< l_c, mm: a column edge is wanted to be 2 l_c long
  std::vector<KnitNode> nodes;
  std::vector<KnitRow> rows;
  std::vector<std::array<int, 2>> columns;       ///< (from, to)
  std::vector<std::vector<double>> row_lengths;  ///< mm, [row][edge]: from a node to its next
  std::vector<double> column_lengths;            ///< mm, follows `columns`
};

}  // namespace meshknit
