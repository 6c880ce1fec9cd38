#include "meshknit/verify/compare_trace.h"

#include <algorithm>
#include <array>
#include <iterator>
#include <string>
#include <utility>

namespace meshknit {
namespace {

class Comparison {
 public:
  Comparison(const Fabric& fabric, const StitchTrace& trace, ProblemLog& log)
      : fabric_(fabric),
        trace_(trace),
        log_(log),
        item_of_(fabric.loops.size()),
        loop_of_(trace.stitches.size(), {-1, -1}) {}

  std::vector<ExpectedLoop> run() {
    assign_items();
    for (int id = 0; id < static_cast<int>(fabric_.loops.size()); ++id) {
      if (!is_object(fabric_.loops[id])) continue;
      check_source(id);
      if (item_of_[id].stitch < 0) continue;
      check_operation(id);
      check_parents(id);
    }
    return std::move(item_of_);
  }

 private:
  // Which loop is which item of the trace: by order alone.
  void assign_items() {
    std::vector<std::vector<int>> made;
    for (const Yarn& yarn : fabric_.yarns) {
      std::vector<int> loops;
      std::copy_if(yarn.loops.begin(), yarn.loops.end(), std::back_inserter(loops),
                   [&](int id) { return is_object(fabric_.loops[id]); });
      if (!loops.empty()) made.push_back(std::move(loops));
    }
    std::vector<std::vector<ExpectedLoop>> expected = expected_yarns(trace_);
    expected.erase(std::remove_if(expected.begin(), expected.end(),
                                  [](const auto& yarn) { return yarn.empty(); }),
                   expected.end());
    std::sort(made.begin(), made.end(),
              [](const auto& a, const auto& b) { return a.front() < b.front(); });
    std::sort(expected.begin(), expected.end(),
              [](const auto& a, const auto& b) { return a.front().stitch < b.front().stitch; });
    if (made.size() != expected.size()) {
      log_.error("yarn-count", 0,
                 "The file knits the object with " + std::to_string(made.size()) +
                     " yarns, the trace has " + std::to_string(expected.size()));
    }
    for (std::size_t y = 0; y < std::min(made.size(), expected.size()); ++y) {
      assign_yarn(made[y], expected[y]);
    }
  }

  void assign_yarn(const std::vector<int>& made, const std::vector<ExpectedLoop>& expected) {
    if (made.size() != expected.size()) {
      log_.error("stitch-count", fabric_.loops[made.back()].line,
                 "a yarn of the object ends here after " + std::to_string(made.size()) +
                     " loops; the trace has " + std::to_string(expected.size()));
    }
    for (std::size_t k = 0; k < std::min(made.size(), expected.size()); ++k) {
      item_of_[made[k]] = expected[k];
      loop_of_[expected[k].stitch][expected[k].which] = made[k];
    }
  }

  void check_source(int id) {
    const Loop& loop = fabric_.loops[id];
    const int stitch = item_of_[id].stitch;
    if (loop.source.kind == Source::Kind::none) {
      log_.error("source-missing", loop.line,
                 "the loop on " + to_string(loop.made_on) + " does not name its source",
                 {stitch}, "Every loop names its stitch, or that it is waste or an anchor.");
    } else if (stitch >= 0 && loop.source.stitch != stitch) {
      log_.error("source-mismatch", loop.line,
                 "the comment names stitch " + std::to_string(loop.source.stitch) +
                     " where stitch " + std::to_string(stitch) + " is due",
                 {stitch, loop.source.stitch});
    }
  }

  const Stitch& stitch_of(int id) const { return trace_.stitches[item_of_[id].stitch]; }

  bool is_second(int id) const { return item_of_[id].which == 1; }

  void check_operation(int id) {
    const Loop& loop = fabric_.loops[id];
    const Stitch& stitch = stitch_of(id);
    const bool tuck = stitch.kind == StitchKind::tuck || is_second(id);
    if (loop.made_by != (tuck ? Op::tuck : Op::knit)) {
      return wrong(
          id, "wrong-kind",
          tuck ? "must be tucked, not pulled through the needle's loops" : "must be knit");
    }
    if (stitch.kind == StitchKind::tuck && loop.below == 0) {
      wrong(id, "tuck-on-empty", "is a tuck that must lie on a loop, but the needle is empty");
    }
    if (is_second(id) && loop.below > 0) {
      wrong(id, "increase-not-on-empty",
            "makes its second loop on a needle that holds loops already");
    }
    check_direction(id);
  }

  void check_direction(int id) {
    const Loop& loop = fabric_.loops[id];
    const Stitch& stitch = stitch_of(id);
    bool clockwise = stitch.direction == Direction::clockwise;
    if (is_second(id)) clockwise = !clockwise;
    if (loop.made_by == Op::tuck && loop.previous >= 0 &&
        fabric_.loops[loop.previous].made_on.bed != loop.made_on.bed) {
      // Round an end of the beds a tuck may be made before or after the carriage turns.
      return;
    }
    if (is_clockwise(loop.made_on.bed, loop.direction) != clockwise) {
      wrong(id, "wrong-direction",
            std::string("must be made ") + (clockwise ? "clockwise" : "anticlockwise"));
    }
  }

  void check_parents(int id) {
    const Loop& loop = fabric_.loops[id];
    const Stitch& stitch = stitch_of(id);
    std::vector<int> through;
    int waste = 0;
    for (int k = loop.first_parent; k < loop.first_parent + loop.parents; ++k) {
      const Loop& parent = fabric_.loops[fabric_.parents[k]];
      if (is_object(parent)) through.push_back(fabric_.parents[k]);
      if (parent.source.kind == Source::Kind::waste) ++waste;
      if (parent.source.kind == Source::Kind::anchor) {
        wrong(id, "anchor-in-object", "is pulled through an anchor, which must come out again");
      }
    }
    const bool start = stitch.kind == StitchKind::start;
    if (start && waste == 0) {
      wrong(id, "start-not-on-waste", "begins the object and must be knit through waste");
    }
    if (!start && waste > 0) {
      wrong(id, "waste-under-object",
            "is knit through waste, which only the object's start may be");
    }
    std::vector<int> wanted;
    if (!is_second(id)) {
      for (const ExpectedLoop& parent : expected_parents(trace_, item_of_[id].stitch)) {
        wanted.push_back(loop_of_[parent.stitch][parent.which]);
      }
    }
    if (through == wanted) return;
    const bool same =
        std::is_permutation(through.begin(), through.end(), wanted.begin(), wanted.end());
    wrong(id, same ? "wrong-stack-order" : "wrong-parents",
          (same ? "goes through the right loops, but they lie in the order "
                : "goes through the loops of the stitches ") +
              named(through) + " instead of " + named(wanted));
  }

  void wrong(int id, const std::string& code, const std::string& what) {
    const int stitch = item_of_[id].stitch;
    log_.error(code, fabric_.loops[id].line, "stitch " + std::to_string(stitch) + " " + what,
               {stitch});
  }

  std::string named(const std::vector<int>& loops) const {
    if (loops.empty()) return "(none)";
    std::string names;
    for (const int id : loops) {
      if (!names.empty()) names += ", ";
      const ExpectedLoop item = id < 0 ? ExpectedLoop{} : item_of_[id];
      names += item.stitch < 0 ? "?" : std::to_string(item.stitch);
      if (item.which == 1) names += " (second loop)";
    }
    return names;
  }

  const Fabric& fabric_;
  const StitchTrace& trace_;
  ProblemLog& log_;
  std::vector<ExpectedLoop> item_of_;        // loop -> item
  std::vector<std::array<int, 2>> loop_of_;  // stitch, which -> loop
};

}  // namespace

std::vector<ExpectedLoop> compare_with_trace(const Fabric& fabric, const StitchTrace& trace,
                                             ProblemLog& log) {
  return Comparison(fabric, trace, log).run();
}

}  // namespace meshknit
