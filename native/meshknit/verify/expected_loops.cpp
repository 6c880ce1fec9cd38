#include "meshknit/verify/expected_loops.h"

#include <algorithm>
#include <string>

namespace meshknit {
namespace {

int loops_of(StitchKind kind) { return kind == StitchKind::increase ? 2 : 1; }

std::size_t children_of(StitchKind kind) {
  if (kind == StitchKind::increase) return 2;
  return kind == StitchKind::end ? 0 : 1;
}

// Parents without the tucks that lie on them.
std::size_t parents_of(StitchKind kind) {
  if (kind == StitchKind::start || kind == StitchKind::tuck) return 0;
  return kind == StitchKind::decrease ? 2 : 1;
}

bool in_range(const StitchTrace& trace, const std::vector<int>& indices) {
  const int count = static_cast<int>(trace.stitches.size());
  return std::all_of(indices.begin(), indices.end(),
                     [&](int index) { return index >= 0 && index < count; });
}

bool has_form(const StitchTrace& trace, int s) {
  const Stitch& stitch = trace.stitches[s];
  if (stitch.yarn < 0 || stitch.yarn >= trace.yarns) return false;
  if (stitch.children.size() != children_of(stitch.kind)) return false;
  const auto tucks = std::count_if(stitch.parents.begin(), stitch.parents.end(), [&](int p) {
    return trace.stitches[p].kind == StitchKind::tuck;
  });
  if (stitch.parents.size() - static_cast<std::size_t>(tucks) != parents_of(stitch.kind)) {
    return false;
  }
  const auto agree = [&](const std::vector<int>& here, std::vector<int> Stitch::*there) {
    return std::all_of(here.begin(), here.end(), [&](int other) {
      const std::vector<int>& back = trace.stitches[other].*there;
      return std::count(here.begin(), here.end(), other) ==
             std::count(back.begin(), back.end(), s);
    });
  };
  return agree(stitch.parents, &Stitch::children) && agree(stitch.children, &Stitch::parents);
}

}  // namespace

bool check_trace_form(const StitchTrace& trace, ProblemLog& log) {
  const int count = static_cast<int>(trace.stitches.size());
  for (const bool indices : {true, false}) {
    for (int s = 0; s < count; ++s) {
      const Stitch& stitch = trace.stitches[s];
      const bool good =
          indices ? in_range(trace, stitch.parents) && in_range(trace, stitch.children)
                  : has_form(trace, s);
      if (good) continue;
      log.error("bad-trace", 0,
                "Stitch " + std::to_string(s) +
                    " of the trace does not fit its kind, parents or children",
                {s}, "Please report this; the trace is wrong before any machine program.");
      return false;
    }
  }
  return true;
}

std::vector<std::vector<ExpectedLoop>> expected_yarns(const StitchTrace& trace) {
  std::vector<std::vector<ExpectedLoop>> yarns(static_cast<std::size_t>(trace.yarns));
  for (int s = 0; s < static_cast<int>(trace.stitches.size()); ++s) {
    const Stitch& stitch = trace.stitches[s];
    for (int which = 0; which < loops_of(stitch.kind); ++which) {
      yarns[stitch.yarn].push_back({s, which});
    }
  }
  return yarns;
}

std::vector<ExpectedLoop> expected_parents(const StitchTrace& trace, int stitch) {
  const Stitch& made = trace.stitches[stitch];
  std::vector<ExpectedLoop> expected;
  int both = 0;  // loops seen of an increase that goes wholly into this stitch
  for (const int p : made.parents) {
    const Stitch& parent = trace.stitches[p];
    int which = 0;
    if (parent.kind == StitchKind::increase) {
      if (parent.children[0] == parent.children[1]) {
        which = parent.direction == made.direction ? both : 1 - both;
        ++both;
      } else {
        which = parent.children[0] == stitch ? 0 : 1;
      }
    }
    expected.push_back({p, which});
  }
  return expected;
}

}  // namespace meshknit
