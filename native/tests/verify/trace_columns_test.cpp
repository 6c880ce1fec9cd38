#include "meshknit/verify/trace_columns.h"

#include <gtest/gtest.h>

#include "bed_picture.h"
#include "graphs.h"
#include "meshknit/tracing/trace.h"

namespace meshknit {
namespace {

TEST(TraceColumns, ATubeNeverPartsWhateverItsShape) {
  for (std::uint64_t seed = 0; seed < 100; ++seed) {
    const StitchTrace trace = trace_knit_graph(random_tube(seed));
    const TraceColumns found = find_trace_columns(trace);
    if (!found.junctions.empty()) {
      const Junction& j = found.junctions[0];
      ADD_FAILURE() << seed << " " << j.stitch << " " << j.first << " " << j.second << "\n"
                    << bed_picture(trace);
      break;
    }
  }
}

}  // namespace
}  // namespace meshknit
