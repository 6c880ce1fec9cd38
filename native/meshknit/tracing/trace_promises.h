#pragma once

#include "meshknit/core/problem.h"
#include "meshknit/knit_graph/knit_graph.h"
#include "meshknit/tracing/stitch.h"

namespace meshknit {

/// The promises of a trace (trace_checks.h), one function each, each Problem naming stitches
/// and nodes. They are to be asked in this order: a promise relies on those before it.

/// Yarns and nodes exist, parents are made earlier, children later. Codes "stitch-...".
Problems check_stitch_indices(const KnitGraph& graph, const StitchTrace& trace);
/// s is a child of p as often as p is a parent of s. Code "family-disagrees".
Problems check_families(const StitchTrace& trace);
/// Kinds fit the numbers of parents, children and tucks; so every loop is knit through exactly
/// once but those of end stitches; a tuck stands right behind the stitch whose loop it lies on.
/// Codes "kind-...", "tuck-order".
Problems check_kinds(const StitchTrace& trace);
/// Every node is knit exactly twice, every graph row counts two courses. Codes
/// "node-not-knit-twice", "wrong-courses".
Problems check_nodes_knit_twice(const KnitGraph& graph, const StitchTrace& trace);
/// Loops go from a node's first stitch to its second and from there along the columns, in loop
/// order. Code "loops-off-columns".
Problems check_loops_follow_columns(const KnitGraph& graph, const StitchTrace& trace);
/// Every stitch is made on the tube of its row. Code "wrong-tube".
Problems check_tubes(const KnitGraph& graph, const StitchTrace& trace);
/// Replays who hangs beside whom: every stitch is made through the loop next to its yarn's last
/// one, closed rows anticlockwise; at a turn the yarn tucks on the loop ahead and comes back;
/// exactly one turn at each end of each short row. Codes "yarn-jumps", "closed-row-reversed",
/// "tuck-misplaced", "turn-missing", "turn-repeated".
///
/// Loops that are decreased together count as one place, since they are stacked before they are
/// knit.
Problems check_yarn_path(const KnitGraph& graph, const StitchTrace& trace);
/// At most n + (k-1) m yarns for n starting rows and m splits into k. Code "too-many-yarns".
Problems check_yarn_count(const KnitGraph& graph, const StitchTrace& trace);

/// An error about stitches of a trace, and their nodes.
Problem stitch_problem(const StitchTrace& trace, std::string code, std::string message,
                       std::vector<int> stitches);

}  // namespace meshknit
