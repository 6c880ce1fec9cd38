#include "meshknit/pipeline/part_seams.h"

#include <algorithm>

namespace meshknit {
namespace {

// The stitch of this kind that a node has.
int stitch_of(const StitchTrace& trace, int node, StitchKind kind) {
  const auto found =
      std::find_if(trace.stitches.begin(), trace.stitches.end(),
                   [&](const Stitch& s) { return s.node == node && s.kind == kind; });
  return static_cast<int>(found - trace.stitches.begin());
}

int line_of(const Program& program, int stitch) {
  const auto found = std::find_if(
      program.instructions.begin(), program.instructions.end(), [&](const Instruction& i) {
        return i.source.kind == Source::Kind::stitch && i.source.stitch == stitch;
      });
  return found->line;
}

int part_of(const std::vector<KnitPart>& parts, int tube) {
  const auto found = std::find_if(parts.begin(), parts.end(),
                                  [&](const KnitPart& part) { return part.tube == tube; });
  return static_cast<int>(found - parts.begin());
}

}  // namespace

std::vector<PartSeam> find_part_seams(const std::vector<Seam>& seams,
                                      const std::vector<KnitPart>& parts,
                                      const Program& program, const StitchTrace& trace) {
  std::vector<PartSeam> result;
  for (const Seam& seam : seams) {
    const int end = stitch_of(trace, seam.columns.front()[0], StitchKind::end);
    const int start = stitch_of(trace, seam.columns.front()[1], StitchKind::start);
    PartSeam joined;
    joined.lower = part_of(parts, trace.stitches[end].tube);
    joined.upper = part_of(parts, trace.stitches[start].tube);
    joined.lower_loops = parts[joined.lower].ends;
    joined.upper_loops = parts[joined.upper].starts;
    joined.lower_line = line_of(program, end);
    joined.upper_line = line_of(program, start);
    result.push_back(joined);
  }
  return result;
}

}  // namespace meshknit
