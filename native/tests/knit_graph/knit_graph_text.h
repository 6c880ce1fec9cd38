#pragma once

#include <string>
#include <string_view>

#include "meshknit/knit_graph/knit_graph.h"

namespace meshknit {

/// A knit graph as a few lines of text, for tests and bug reports:
///
///     knit-graph 1
///     stitch 3.66 1.73                    width and height, mm
///     node 0 0 0 -1                       x y z time; numbered from 0
///     closed 0 1 2 lengths 3.6 3.7 3.7    nodes in yarn order, then the length of each row
///     edge short 3 4 lengths 3.6 column 0 3 3.4                      from, to, length
///
/// '#' starts a comment; blank lines are skipped.
/// Ensures: read_knit_graph(result) gives the same graph, to the last bit.
std::string write_knit_graph(const KnitGraph& graph);

/// Throws: InvalidInput naming the line that is not of this form. The graph's own sense is left
/// to check_graph_form.
KnitGraph read_knit_graph(std::string_view text);

}  // namespace meshknit
