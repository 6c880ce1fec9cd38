#include "meshknit/verify/loop_fates.h"

#include <string>
#include <vector>

namespace meshknit {
namespace {

void check_end(const Fabric& fabric, const Loop& loop, int stitch, ProblemLog& log) {
  const int out = fabric.yarns[loop.yarn].line_out;
  const bool dropped = loop.fate == Loop::Fate::dropped && loop.child < 0;
  if (dropped && (out == 0 || loop.fate_line < out)) {
    log.error("end-dropped-early", loop.fate_line,
              "the last loop of stitch " + std::to_string(stitch) +
                  " is dropped while its yarn is still in",
              {stitch});
  }
}

// The object's last loops hang on the waste that is knit through them.
void check_waste_above(const Fabric& fabric, ProblemLog& log) {
  std::vector<bool> carries(fabric.loops.size(), false);
  for (std::size_t id = 0; id < fabric.loops.size(); ++id) {
    const Loop& loop = fabric.loops[id];
    if (is_object(loop)) continue;
    for (int k = loop.first_parent; k < loop.first_parent + loop.parents; ++k) {
      const int below = fabric.parents[k];
      if (is_object(fabric.loops[below]) || carries[below]) carries[id] = true;
    }
    if (!carries[id] || loop.child >= 0 || loop.fate != Loop::Fate::dropped) continue;
    const int out = fabric.yarns[loop.yarn].line_out;
    if (out > 0 && out < loop.fate_line) continue;
    log.error("waste-dropped-early", loop.fate_line,
              "waste that the object hangs on is dropped while its yarn is still in");
  }
}

}  // namespace

void check_loop_fates(const Fabric& fabric, const StitchTrace& trace,
                      const std::vector<ExpectedLoop>& items, ProblemLog& log) {
  check_waste_above(fabric, log);
  for (std::size_t id = 0; id < fabric.loops.size(); ++id) {
    const Loop& loop = fabric.loops[id];
    if (!is_object(loop)) continue;
    const int stitch = items[id].stitch;
    if (stitch >= 0 && trace.stitches[stitch].kind == StitchKind::end) {
      check_end(fabric, loop, stitch, log);
      continue;
    }
    if (loop.child < 0 && loop.fate == Loop::Fate::dropped) {
      log.error("loop-dropped", loop.fate_line,
                "the loop on " + to_string(loop.hangs_on) +
                    " is dropped without having been knit through; it would run",
                {stitch});
    }
    if (loop.child >= 0 && !is_object(fabric.loops[loop.child])) {
      log.error("waste-through-object", fabric.loops[loop.child].line,
                "waste is knit through a loop of the object that does not end there", {stitch});
    }
  }
}

}  // namespace meshknit
