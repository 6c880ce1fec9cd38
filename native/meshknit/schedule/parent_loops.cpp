#include <algorithm>

#include "meshknit/schedule/tube_steps.h"

namespace meshknit {
namespace {

// Which loop of `parent` a child's parent list means at `entry`.
int which_loop(const StitchTrace& trace, const Stitch& child, int child_index, size_t entry) {
  const int parent_index = child.parents[entry];
  const Stitch& parent = trace.stitches[parent_index];
  if (parent.children.size() < 2) return 0;
  if (parent.children[0] != parent.children[1])
    return parent.children[1] == child_index ? 1 : 0;
  // Both loops are decreased together again: the child meets them in the order of its own
  // direction.
  const auto begin = child.parents.begin();
  const bool met_before = std::find(begin, begin + static_cast<long>(entry), parent_index) !=
                          begin + static_cast<long>(entry);
  return met_before == (parent.direction == child.direction) ? 1 : 0;
}

}  // namespace

std::vector<LoopName> parent_loops(const StitchTrace& trace, int stitch) {
  const Stitch& child = trace.stitches[stitch];
  std::vector<LoopName> loops;
  loops.reserve(child.parents.size());
  for (size_t entry = 0; entry < child.parents.size(); ++entry)
    loops.push_back({child.parents[entry], which_loop(trace, child, stitch, entry)});
  return loops;
}

LoopName tucked_loop(const StitchTrace& trace, int tuck) {
  if (trace.stitches[tuck].children.empty()) return {};
  const std::vector<LoopName> loops =
      parent_loops(trace, trace.stitches[tuck].children.front());
  LoopName below;
  for (const LoopName& loop : loops) {
    if (loop.stitch == tuck) return below;
    if (trace.stitches[loop.stitch].kind != StitchKind::tuck) below = loop;
  }
  return {};
}

}  // namespace meshknit
