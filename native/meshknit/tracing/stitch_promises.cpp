// Promises that stitches keep among themselves, whatever the graph.

#include <algorithm>
#include <iterator>
#include <string>
#include <utility>

#include "meshknit/tracing/trace_promises.h"

namespace meshknit {
namespace {

std::string name(int stitch) { return "Stitch " + std::to_string(stitch); }

/// How many loops a kind knits through and how many it leaves for others.
struct Loops {
  int through = 1;
  int made = 1;
};

Loops loops_of(StitchKind kind) {
  switch (kind) {
    case StitchKind::start:
      return {0, 1};
    case StitchKind::knit:
      return {1, 1};
    case StitchKind::increase:
      return {1, 2};
    case StitchKind::decrease:
      return {2, 1};
    case StitchKind::tuck:
      return {0, 1};
    case StitchKind::end:
      return {1, 0};
  }
  return {};
}

/// (parent, child) pairs as told by one side, in ascending order.
using Pairs = std::vector<std::pair<int, int>>;

Pairs pairs_by(const StitchTrace& trace, bool parents) {
  Pairs pairs;
  for (int s = 0; s < static_cast<int>(trace.stitches.size()); ++s)
    for (const int other : parents ? trace.stitches[s].parents : trace.stitches[s].children)
      pairs.push_back(parents ? std::make_pair(other, s) : std::make_pair(s, other));
  std::sort(pairs.begin(), pairs.end());
  return pairs;
}

void check_tucks_behind_their_loops(const StitchTrace& trace, int s, Problems& problems) {
  int loop_parent = -1, last_tuck = -1;
  for (const int parent : trace.stitches[s].parents) {
    const Stitch& stitch = trace.stitches[parent];
    if (stitch.kind != StitchKind::tuck) {
      loop_parent = parent;
      last_tuck = -1;
      continue;
    }
    const bool in_place = loop_parent >= 0 && loop_parent < parent && last_tuck < parent &&
                          trace.stitches[loop_parent].node == stitch.node;
    if (!in_place)
      problems.push_back(stitch_problem(trace, "tuck-order",
                                        name(s) + " does not name tuck " +
                                            std::to_string(parent) +
                                            " right behind the stitch whose loop it lies on.",
                                        {s, parent}));
    last_tuck = parent;
  }
}

}  // namespace

Problem stitch_problem(const StitchTrace& trace, std::string code, std::string message,
                       std::vector<int> stitches) {
  Problem problem;
  problem.code = std::move(code);
  problem.message = std::move(message);
  problem.remedy = "This should not happen: please report it with the knit graph.";
  for (const int stitch : stitches)
    problem.elements.nodes.push_back(trace.stitches[stitch].node);
  problem.elements.stitches = std::move(stitches);
  return problem;
}

Problems check_stitch_indices(const KnitGraph& graph, const StitchTrace& trace) {
  Problems problems;
  const int stitches = static_cast<int>(trace.stitches.size());
  const int nodes = static_cast<int>(graph.nodes.size());
  for (int s = 0; s < stitches; ++s) {
    const Stitch& stitch = trace.stitches[s];
    if (stitch.yarn < 0 || stitch.yarn >= trace.yarns)
      problems.push_back(stitch_problem(trace, "stitch-without-yarn",
                                        name(s) + " has a yarn that is not there.", {s}));
    if (stitch.node < 0 || stitch.node >= nodes)
      problems.push_back(stitch_problem(trace, "stitch-without-node",
                                        name(s) + " has a node that is not there.", {s}));
    for (const int parent : stitch.parents)
      if (parent < 0 || parent >= s)
        problems.push_back(
            stitch_problem(trace, "stitch-before-parent",
                           name(s) + " knits through a loop that is not made yet.", {s}));
    for (const int child : stitch.children)
      if (child <= s || child >= stitches)
        problems.push_back(stitch_problem(trace, "stitch-after-child",
                                          name(s) + " names a child that is not made later.",
                                          {s}));
  }
  return problems;
}

Problems check_families(const StitchTrace& trace) {
  const Pairs by_children = pairs_by(trace, false), by_parents = pairs_by(trace, true);
  Pairs disagree;
  std::set_symmetric_difference(by_children.begin(), by_children.end(), by_parents.begin(),
                                by_parents.end(), std::back_inserter(disagree));
  Problems problems;
  for (const auto& [parent, child] : disagree)
    problems.push_back(stitch_problem(trace, "family-disagrees",
                                      "Stitches " + std::to_string(parent) + " and " +
                                          std::to_string(child) +
                                          " do not agree on being parent and child.",
                                      {parent, child}));
  return problems;
}

Problems check_kinds(const StitchTrace& trace) {
  Problems problems;
  for (int s = 0; s < static_cast<int>(trace.stitches.size()); ++s) {
    const Stitch& stitch = trace.stitches[s];
    const Loops loops = loops_of(stitch.kind);
    const auto is_tuck = [&](int p) { return trace.stitches[p].kind == StitchKind::tuck; };
    const int tucks =
        static_cast<int>(std::count_if(stitch.parents.begin(), stitch.parents.end(), is_tuck));
    const int through = static_cast<int>(stitch.parents.size()) - tucks;
    if (through != loops.through)
      problems.push_back(stitch_problem(trace, "kind-parents",
                                        name(s) + " knits through " + std::to_string(through) +
                                            " loops; its kind knits through " +
                                            std::to_string(loops.through) + ".",
                                        {s}));
    if (static_cast<int>(stitch.children.size()) != loops.made)
      problems.push_back(stitch_problem(
          trace, "kind-children",
          std::to_string(stitch.children.size()) + " loops of stitch " + std::to_string(s) +
              " are knit through later; its kind makes " + std::to_string(loops.made) + ".",
          {s}));
    check_tucks_behind_their_loops(trace, s, problems);
  }
  return problems;
}

}  // namespace meshknit
