#include "meshknit/remesh/remesh.h"

#include <cmath>
#include <string>

#include "meshknit/core/error.h"
#include "meshknit/remesh/peeling.h"

namespace meshknit {
namespace {

// Part of the time that peeling takes; the rest is relaxation.
constexpr double share_of_peeling = 0.75;

void require_one_tube(const Surface& surface) {
  if (surface.boundaries.size() == 2 && surface.genus == 0) return;
  Problem problem;
  problem.code = "needs-one-tube";
  problem.message = "This surface has " + std::to_string(surface.boundaries.size()) +
                    " boundaries and " + std::to_string(surface.genus) +
                    " handles; one tube with two boundaries can be knit so far.";
  problem.remedy =
      "Close or cut away all boundaries but the two where knitting starts and ends.";
  for (std::size_t i = 0; i < surface.boundaries.size(); ++i)
    problem.elements.boundaries.push_back(static_cast<int>(i));
  throw NotKnittable({problem});
}

// More nodes than any bed holds or any night knits: nearly always a wrong unit. Refused before
// memory runs out.
constexpr double most_nodes = 300000.0;

void require_sensible_size(const Surface& surface, const RemeshOptions& options) {
  const double nodes = surface.area / (2.0 * options.stitch_height * options.stitch_width);
  if (nodes <= most_nodes) return;
  Problem problem;
  problem.code = "too-many-stitches";
  problem.message = "At this size the surface has " +
                    std::to_string(std::lround(surface.area / 1e6)) +
                    " square metres, which take more than " +
                    std::to_string(std::lround(2.0 * most_nodes)) + " stitches.";
  problem.remedy =
      "Check the size or scale: lengths are taken as millimetres after scaling. At " +
      std::to_string(static_cast<int>(100.0 * std::sqrt(most_nodes / nodes))) +
      " % of this size it could be tried.";
  throw NotKnittable({problem});
}

}  // namespace

KnitGraph remesh(const Surface& surface, const std::vector<double>& time,
                 const RemeshOptions& options, RunContext* run) {
  if (time.size() != surface.mesh.n_vertices())
    throw InvalidInput("remesh: one time per mesh vertex is needed");
  if (!(options.stitch_width > 0.0) || !(options.stitch_height > 0.0))
    throw InvalidInput("remesh: stitch width and height must be positive");
  require_one_tube(surface);
  require_sensible_size(surface, options);
  report(run, 0.0);
  Peeling peeling(surface, time, options);
  while (!peeling.done()) {
    report(run, share_of_peeling * peeling.progress());
    peeling.peel_row();
  }
  KnitGraph graph = peeling.take_graph([&](double fraction) {
    report(run, share_of_peeling + (1.0 - share_of_peeling) * fraction);
  });
  report(run, 1.0);
  return graph;
}

}  // namespace meshknit
