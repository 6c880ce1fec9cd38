#include "meshknit/emit/carriers.h"

#include <algorithm>

#include "meshknit/core/error.h"

namespace meshknit {
namespace {

[[noreturn]] void refuse(const StitchTrace& trace, int stitch, const std::vector<YarnUse>& uses,
                         size_t carriers) {
  Problem problem;
  problem.code = "too-many-carriers";
  for (const YarnUse& use : uses) {
    if (use.first_stitch > stitch || use.last_stitch < stitch) continue;
    problem.elements.stitches.push_back(use.first_stitch);
    problem.elements.nodes.push_back(trace.stitches[use.first_stitch].node);
  }
  if (carriers == 0) {
    problem.message =
        "The machine has no carrier for the object's yarn: it keeps all that it has for waste "
        "and "
        "draw thread.";
    problem.remedy = "Add a carrier to the machine's profile, or choose another machine.";
    throw NotKnittable({problem});
  }
  problem.message =
      "At stitch " + std::to_string(stitch) + " " +
      std::to_string(problem.elements.stitches.size()) +
      " tubes are knit side by side, each with a yarn of its own, but the machine "
      "has carriers for " +
      std::to_string(carriers) + ".";
  problem.remedy =
      "Change the knitting times so that fewer tubes are knit at the same time, or choose a "
      "machine with more carriers.";
  throw NotKnittable({problem});
}

}  // namespace

std::vector<YarnUse> assign_carriers(const StitchTrace& trace, const MachineProfile& profile) {
  std::vector<YarnUse> uses(trace.yarns);
  for (int s = 0; s < static_cast<int>(trace.stitches.size()); ++s) {
    YarnUse& use = uses[trace.stitches[s].yarn];
    if (use.first_stitch < 0) use.first_stitch = s;
    use.last_stitch = s;
  }
  const std::vector<std::string> carriers = carriers_for_yarn(profile);
  std::vector<int> busy_until(carriers.size(), -1);
  std::vector<YarnUse*> by_time;
  for (YarnUse& use : uses) by_time.push_back(&use);
  std::sort(by_time.begin(), by_time.end(), [](const YarnUse* a, const YarnUse* b) {
    return a->first_stitch < b->first_stitch;
  });
  for (YarnUse* use : by_time) {
    const auto free = std::find_if(busy_until.begin(), busy_until.end(),
                                   [&](int until) { return until < use->first_stitch; });
    if (free == busy_until.end()) refuse(trace, use->first_stitch, uses, carriers.size());
    use->carrier = carriers[free - busy_until.begin()];
    *free = use->last_stitch;
  }
  return uses;
}

}  // namespace meshknit
