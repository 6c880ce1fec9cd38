#pragma once

#include <string>
#include <vector>

#include "meshknit/core/problem.h"

namespace meshknit {

/// An error (or a warning) about nodes of a knit graph.
Problem node_problem(std::string code, std::string message, std::string remedy,
                     std::vector<int> nodes, Severity severity = Severity::error);

/// What to do about a knit graph with a property broken: the graph comes from remeshing, or
/// from a file.
extern const char* const kMendGraph;

}  // namespace meshknit
