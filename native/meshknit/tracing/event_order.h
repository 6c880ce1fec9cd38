#pragma once

#include <vector>

#include "meshknit/knit_graph/knit_graph.h"
#include "meshknit/tracing/stitch.h"
#include "meshknit/tracing/tube_events.h"
#include "meshknit/tracing/tubes.h"

namespace meshknit {

/// An order of events in which tubes can hang side by side without crossing: a level planar drawing
/// of the Reeb graph (paper, section 2.2). If there is one, it is such that no more than `most_tubes`
/// hang at once, so that no more yarns are in use. Empty if the order of time is one, so that nothing
/// need be done, or if none was found; all orders are tried for objects of a dozen tubes.
/// Requires: check_knit_graph(graph) finds no error; most_tubes >= 1.
std::vector<TubeEvent> find_event_order(const KnitGraph& graph, const Tubes& tubes,
                                        int most_tubes);

/// Two more orders without crossings, where they exist: that of time, and one in which tubes part, meet
/// and end as soon as they can (hanging_order.h). For yarns that run out in the first one.
/// Requires: check_knit_graph(graph) finds no error.
std::vector<std::vector<TubeEvent>> more_event_orders(const KnitGraph& graph,
                                                      const Tubes& tubes);

/// True if tubes would have to cross where they start, part, meet and end in the order of this trace of
/// the graph. False, too, if they can hang in too many ways to try.
bool tubes_cross(const KnitGraph& graph, const Tubes& tubes, const StitchTrace& trace);

}  // namespace meshknit
