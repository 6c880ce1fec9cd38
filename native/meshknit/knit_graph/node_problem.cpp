#include "meshknit/knit_graph/node_problem.h"

#include <utility>

namespace meshknit {

const char* const kMendGraph =
    "Smooth the mesh or the knitting times around these nodes and build the graph again; if "
    "the "
    "graph comes from a file, correct it there.";

Problem node_problem(std::string code, std::string message, std::string remedy,
                     std::vector<int> nodes, Severity severity) {
  Problem problem;
  problem.code = std::move(code);
  problem.severity = severity;
  problem.message = std::move(message);
  problem.remedy = std::move(remedy);
  problem.elements.nodes = std::move(nodes);
  return problem;
}

}  // namespace meshknit
