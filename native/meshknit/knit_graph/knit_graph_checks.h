#pragma once

#include <array>

#include "meshknit/core/problem.h"
#include "meshknit/knit_graph/knit_graph.h"

namespace meshknit {

/// Indices in range, every node in exactly one row, closed rows of at least 3 nodes, lengths
/// present and positive, columns in the documented order. The other checks require this one to
/// find nothing.
Problems check_graph_form(const KnitGraph& graph);

/// One function a property of the paper (3.2, "Knit Graph Properties"). Each violation is one
/// Problem with code "property-N-..." that names its nodes.

/// Property 1.
Problems check_consistent_orientation(const KnitGraph& graph);
/// Property 2: no cycle among the rows (one Problem a cycle, naming all its nodes), and rows
/// listed in an order that the columns allow.
Problems check_helix_free(const KnitGraph& graph);
/// Property 3: at most two columns up and two down; and, so that no loop is left over and none
/// comes from nowhere, the nodes of a row have columns up (down) either all or none.
Problems check_node_degree(const KnitGraph& graph);
/// Property 4: one column up and one down at the ends of short rows; and, what the paper draws
/// from it, increases and decreases only between row-wise neighbours.
Problems check_simple_short_rows(const KnitGraph& graph);
/// Property 5, for any number of splits and merges as closed_row_links.h defines them. Requires
/// Property 2.
Problems check_simple_splits(const KnitGraph& graph);
/// Property 6 (split_layout.h). Requires Properties 2 and 5.
Problems check_feasible_splits(const KnitGraph& graph);
/// Property 7, two warnings at most: columns that do not climb in time, and row edges that gain
/// more time than an average column edge.
Problems check_time_aligned(const KnitGraph& graph);

/// Bins for signed errors (length - wanted) / wanted: 5 % wide from -50 % to 50 %, each with its
/// lower bound, and one for all that is below and one for all that is above.
inline constexpr int histogram_bins = 22;
/// Between bin k and bin k + 1. Requires: 0 <= k < histogram_bins - 1.
constexpr double histogram_bound(int k) { return (k - 10) / 20.0; }

/// Relative length errors |length - wanted| / wanted of one kind of edge (Property 8). The 95th
/// percentile is the smallest error that at least 95 % of the edges do not exceed.
struct LengthError {
  int edges = 0;
  double mean = 0.0;
  double p95 = 0.0;
  double within_10 = 0.0;  ///< fraction of edges within 10 %
  double within_20 = 0.0;
  std::array<int, histogram_bins> histogram{};  ///< edges a bin: too short first
};

/// What the report says of a graph.
struct KnitGraphStats {
  int nodes = 0, rows = 0, short_rows = 0;
  int splits = 0, merges = 0;  ///< k - 1 of them where a row parts into k, or k meet in one
  int increases = 0, decreases = 0;  ///< nodes with two columns up, with two down
  int short_row_ends = 0;
  int irregular = 0;  ///< nodes that are one or more of these three
  LengthError row_error, column_error;
};
KnitGraphStats measure_graph(const KnitGraph& graph);

/// Form and Properties 1-7 together. `violations[k]` counts the errors of Property k+1, k =
/// 0..5. Checks that require an earlier one are left out when that one found something.
struct KnitGraphCheck {
  Problems problems;
  std::array<int, 6> violations{};
};
KnitGraphCheck check_knit_graph(const KnitGraph& graph);

}  // namespace meshknit
