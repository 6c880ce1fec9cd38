#pragma once

#include <vector>

#include "meshknit/knit_graph/knit_graph.h"
#include "meshknit/tracing/tubes.h"

namespace meshknit {

/// What happens to the tubes on the bed.
struct TubeEvent {
  enum class Kind { start, split, merge, end } kind = Kind::start;
  int tube = 0;  ///< that starts, that parts, that others become, that ends
};

/// Which tubes a tube takes over, and which take it over, as they hang from one side to the other;
/// when it begins and ends.
struct TubeLinks {
  std::vector<int> below, above;
  double begin = 0.0, end = 0.0;
};

/// True if the tubes can hang side by side without crossing in some order of events, or if there are
/// too many to try.
bool can_hang(const std::vector<TubeLinks>& tubes);

/// An order of events in which tubes can hang side by side without crossing: a level planar drawing
/// of the Reeb graph (paper, section 2.2). If there is one, it is such that no more than `most_tubes`
/// hang at once, so that no more yarns are in use. Empty if the order of time is one, so that nothing
/// need be done, or if none was found; all orders are tried for objects of a dozen tubes.
/// Requires: check_knit_graph(graph) finds no error; most_tubes >= 1.
std::vector<TubeEvent> find_event_order(const KnitGraph& graph, const Tubes& tubes,
                                        int most_tubes);

}  // namespace meshknit
