#include "meshknit/tracing/stitch.h"

namespace meshknit {

const char* name_of(StitchKind kind) {
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
  return "knit";
}

}  // namespace meshknit
