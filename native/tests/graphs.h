#pragma once

#include <cstdint>
#include <string>
#include <vector>

#include "meshknit/knit_graph/knit_graph.h"

namespace meshknit {

/// Hand-drawn knit graphs, for the tests of all stages.
///
/// Draws a graph row by row. The front is what a next row can stand on: nodes without columns
/// up, in yarn order round a tube. A row is linked by a string with one letter a link, in the
/// order of the front:
///
///     |  one node over one
///     Y  two nodes over one (increase)
///     A  one node over two (decrease)
///
/// Row edges are l_r long, columns 2 l_c; new nodes lie above the middle of their parents; a
/// row's time is its height.
class GraphDrawing {
 public:
  using Front = std::vector<int>;

  /// A closed row of n nodes on nothing.
  Front cast_on(int n);
  /// A closed row over the whole front. Its node list begins at the given link's (first) node,
  /// its front at link 0.
  Front closed_row(const Front& front, const std::string& links, int begin = 0);
  /// A short row over the front's nodes from `begin` on, round its end if need be.
  Front short_row(const Front& front, int begin, const std::string& links);
  /// The graph so far, complete in form.
  KnitGraph graph() const;

  const KnitRow& row(int index) const { return graph_.rows[index]; }
  int rows() const { return static_cast<int>(graph_.rows.size()); }

  /// A column that no link string draws: for graphs that are meant to be bad.
  void add_column(int from, int to) { graph_.columns.push_back({from, to}); }

 private:
  Front add_row(const Front& covered, const std::string& links, bool closed);

  KnitGraph graph_;
  std::vector<int> level_;  ///< of each node: rows below it
};

/// n links of one kind.
std::string links(int n, char kind = '|');

/// `rows` closed rows of n nodes each.
KnitGraph plain_tube(int n, int rows);

/// A tube that begins with n nodes; each string links one further closed row.
KnitGraph shaped_tube(int n, const std::vector<std::string>& rows);

/// A short row to draw: where it begins on the front of that moment, and its links.
struct DrawnShortRow {
  int begin = 0;
  std::string links;
};

/// A tube of n nodes: a closed row, these short rows one after another, then `rows_after`
/// closed rows one to one.
KnitGraph tube_with_short_rows(int n, const std::vector<DrawnShortRow>& short_rows,
                               int rows_after = 2);

KnitGraph one_short_row();        ///< 10 nodes round, 4 wide
KnitGraph short_row_over_seam();  ///< covers where the node list ends and the yarn goes up
KnitGraph nested_short_rows();    ///< 8, then 6, then 4 wide, centred over each other
KnitGraph short_row_with_increase();
KnitGraph stacked_short_rows(int k);  ///< k of them, ends directly above ends

/// Bad: one row that winds up three times round a tube of 6 nodes, every turn standing on the
/// one before (Property 2).
KnitGraph helix();
/// Bad: a tube whose middle row is listed backwards (Property 1).
KnitGraph flipped_row();

/// Trousers: a tube of 2 n nodes, 3 rows, that parts into two of n nodes, 3 rows each.
KnitGraph splitting_tube(int n);
/// The same upside down.
KnitGraph merging_tube(int n);
/// A tube of a + b1 + c + b2 nodes that parts into three tubes side by side, of a, b1 + b2 and
/// c nodes; the middle one takes b1 loops from one side and b2 from the other.
KnitGraph three_way_split(int a, int b1, int c, int b2);

/// A small generator of our own, so that random tests are the same everywhere (linear
/// congruential, Knuth's MMIX constants).
class Dice {
 public:
  explicit Dice(std::uint64_t seed) : state_(seed * 2654435761u + 1) {}
  /// A whole number in [0, sides).
  int roll(int sides);

 private:
  std::uint64_t state_;
};

/// A valid tube: random counts, increases, decreases and short rows (also nested, stacked, and
/// over the seam), 8 to 40 rows of 5 to 40 nodes.
KnitGraph random_tube(std::uint64_t seed);

}  // namespace meshknit
