#include "meshknit/verify/waste_rules.h"

#include <algorithm>
#include <map>
#include <string>

namespace meshknit {
namespace {

class WasteBelow {
 public:
  WasteBelow(const Fabric& fabric, const MachineProfile& profile)
      : fabric_(fabric), profile_(profile), courses_(fabric.loops.size(), 0) {
    // Parents are made before their children.
    for (std::size_t id = 0; id < fabric.loops.size(); ++id) {
      if (is_object(fabric.loops[id])) continue;
      courses_[id] =
          below(static_cast<int>(id)) + (is_draw_thread(static_cast<int>(id)) ? 0 : 1);
    }
  }

  /// Courses of waste below a loop, draw thread not counted.
  int below(int id) const {
    int most = 0;
    for_parents(id, [&](int parent) { most = std::max(most, courses_[parent]); });
    return most;
  }

  bool hangs_on_draw_thread(int id) const {
    bool all = fabric_.loops[id].parents > 0;
    for_parents(id, [&](int parent) { all = all && is_draw_thread(parent); });
    return all;
  }

 private:
  template <class Use>
  void for_parents(int id, Use use) const {
    const Loop& loop = fabric_.loops[id];
    for (int k = loop.first_parent; k < loop.first_parent + loop.parents; ++k)
      use(fabric_.parents[k]);
  }

  bool is_draw_thread(int id) const {
    const Loop& loop = fabric_.loops[id];
    return !is_object(loop) && fabric_.yarns[loop.yarn].carrier == profile_.draw_carrier;
  }

  const Fabric& fabric_;
  const MachineProfile& profile_;
  std::vector<int> courses_;
};

struct Span {
  int line = 0, lowest = 0, highest = 0;
};

}  // namespace

void check_waste_below(const Fabric& fabric, const StitchTrace& trace,
                       const std::vector<ExpectedLoop>& items, const MachineProfile& profile,
                       ProblemLog& log) {
  const WasteBelow waste(fabric, profile);
  std::map<int, Span> starts;  // tube -> needles on which it starts
  for (std::size_t id = 0; id < items.size(); ++id) {
    const int stitch = items[id].stitch;
    if (stitch < 0 || trace.stitches[stitch].kind != StitchKind::start) continue;
    const Loop& loop = fabric.loops[id];
    const int courses = waste.below(static_cast<int>(id));
    if (courses < profile.take_down_rounds)
      log.error("waste-too-short", loop.line,
                "the object begins on " + std::to_string(courses) + " courses of waste; " +
                    std::to_string(profile.take_down_rounds) +
                    " are needed to reach the rollers",
                {stitch});
    if (!profile.draw_carrier.empty() && !waste.hangs_on_draw_thread(static_cast<int>(id)))
      log.error("no-draw-thread", loop.line,
                "the object begins on something else than draw thread of carrier " +
                    profile.draw_carrier,
                {stitch});
    const int needle = loop.made_on.index;
    Span& span =
        starts.try_emplace(trace.stitches[stitch].tube, Span{loop.line, needle, needle})
            .first->second;
    span.lowest = std::min(span.lowest, needle);
    span.highest = std::max(span.highest, needle);
  }
  for (const auto& [tube, span] : starts) {
    const int width = span.highest - span.lowest + 1;
    if (width < profile.take_down_width)
      log.warning("narrow-start", span.line,
                  "a tube starts " + std::to_string(width) +
                      " needles wide; the rollers hold " +
                      std::to_string(profile.take_down_width) + " or more",
                  {}, "Hang a weight on its waste, or make its opening larger.");
  }
}

}  // namespace meshknit
