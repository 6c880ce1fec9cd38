#include "bed_picture.h"

namespace meshknit {
namespace {

std::string kind_name(StitchKind kind) {
  switch (kind) {
    case StitchKind::start:
      return "start";
    case StitchKind::knit:
      return "knit";
    case StitchKind::increase:
      return "increase";
    case StitchKind::decrease:
      return "decrease";
    case StitchKind::tuck:
      return "tuck";
    case StitchKind::end:
      return "end";
  }
  return "?";
}

}  // namespace

std::string bed_picture(const StitchTrace& trace) {
  std::string text;
  const Stitch* before = nullptr;
  for (std::size_t i = 0; i < trace.stitches.size(); ++i) {
    const Stitch& stitch = trace.stitches[i];
    if (!before || before->yarn != stitch.yarn || before->direction != stitch.direction)
      text += "\nyarn " + std::to_string(stitch.yarn) +
              (stitch.direction == Direction::anticlockwise ? "  ->" : "  <-");
    text += "  " + std::to_string(i) + " " + kind_name(stitch.kind) + "@" +
            std::to_string(stitch.node);
    for (std::size_t k = 0; k < stitch.parents.size(); ++k)
      text += (k == 0 ? "^" : ",") + std::to_string(stitch.parents[k]);
    before = &stitch;
  }
  return text + "\n";
}

}  // namespace meshknit
