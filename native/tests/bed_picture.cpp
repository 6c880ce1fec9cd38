#include "bed_picture.h"

namespace meshknit {

std::string bed_picture(const StitchTrace& trace) {
  std::string text;
  const Stitch* before = nullptr;
  for (std::size_t i = 0; i < trace.stitches.size(); ++i) {
    const Stitch& stitch = trace.stitches[i];
    if (!before || before->yarn != stitch.yarn || before->direction != stitch.direction)
      text += "\nyarn " + std::to_string(stitch.yarn) +
              (stitch.direction == Direction::anticlockwise ? "  ->" : "  <-");
    text += "  " + std::to_string(i) + " " + name_of(stitch.kind) + "@" +
            std::to_string(stitch.node);
    for (std::size_t k = 0; k < stitch.parents.size(); ++k)
      text += (k == 0 ? "^" : ",") + std::to_string(stitch.parents[k]);
    before = &stitch;
  }
  return text + "\n";
}

}  // namespace meshknit
