#include "meshknit/tracing/knit_twice.h"

namespace meshknit {

KnitTwice find_stitches(const KnitGraph& graph, const StitchTrace& trace) {
  KnitTwice knit;
  knit.first.assign(graph.nodes.size(), -1);
  knit.second.assign(graph.nodes.size(), -1);
  for (int s = 0; s < static_cast<int>(trace.stitches.size()); ++s) {
    const Stitch& stitch = trace.stitches[s];
    if (stitch.kind == StitchKind::tuck) continue;
    (knit.first[stitch.node] < 0 ? knit.first : knit.second)[stitch.node] = s;
  }
  return knit;
}

std::vector<int> loop_parents(const StitchTrace& trace, int stitch) {
  std::vector<int> parents;
  for (const int parent : trace.stitches[stitch].parents)
    if (trace.stitches[parent].kind != StitchKind::tuck) parents.push_back(parent);
  return parents;
}

}  // namespace meshknit
