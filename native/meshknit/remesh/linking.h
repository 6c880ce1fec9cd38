#pragma once

#include <array>
#include <vector>

namespace meshknit {

/// Two rows to be linked (paper, 3.2.3): nodes of the active cycle and of the next one, both in
/// row order round their loops. Lengths in mm.
struct LinkProblem {
  std::vector<double> active;       ///< place on the active cycle
  std::vector<double> image;        ///< nearest place on the next cycle of each active node
  std::vector<char> active_single;  ///< may be linked 1-1 only
  std::vector<char> active_shaped;  ///< was increased or decreased in the row below
  double active_length = 0.0;
  std::vector<double> next;  ///< place on the next cycle
  std::vector<double> foot;  ///< nearest place on the active cycle of each next node
  std::vector<double> gap;   ///< distance of each next node from the active cycle
  std::vector<char> next_single;
  double next_length = 0.0;
  double row_height = 3.46;  ///< 2 l_c
};

/// A column edge: index of an active and of a next node.
using Link = std::array<int, 2>;

/// Sideways distance of an active node and a next node, measured on both cycles and averaged.
double sideways(const LinkProblem& problem, int active, int next);

/// Fewest and most nodes that a next cycle may have so that links exist (Properties 3-5): each
/// single node takes one, each other run of k nodes between ceil(k/2) and 2k.
std::array<int, 2> linkable_counts(const std::vector<char>& active_single);

/// The links of least summed squared length among 1-1, 1-2 and 2-1 links in order round the
/// loops, with a small charge for shaping next to shaping. In order of the active nodes,
/// beginning anywhere. Empty if there are none.
std::vector<Link> link_rows(const LinkProblem& problem);

}  // namespace meshknit
