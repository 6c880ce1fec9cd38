#include "meshknit/remesh/remesh.h"

#include <algorithm>
#include <cmath>
#include <optional>
#include <string>

#include "meshknit/core/error.h"
#include "meshknit/remesh/junction.h"
#include "meshknit/remesh/peeling.h"

namespace meshknit {
namespace {

// Part of the time that peeling takes; the rest is evening out.
constexpr double share_of_peeling = 0.75;

// More than any machine knits: nearly always a wrong unit or gauge. Refused before memory runs out.
constexpr double most_nodes = 300000.0;
constexpr double most_in_a_row = 4000.0;
constexpr double most_fine_triangles = 6e6;

std::string percent(double part) {
  return std::to_string(std::max(1L, std::lround(100.0 * part))) + " %";
}

void require_sensible_size(const Surface& surface, const RemeshOptions& options) {
  const double row_height = 2.0 * options.stitch_height;
  const double nodes = surface.area / (row_height * options.stitch_width);
  double row = 0.0;
  for (const BoundaryLoop& loop : surface.boundaries)
    row = std::max(row, loop.length / options.stitch_width);
  // Triangles of the fine mesh have edges of at most a part of the smaller dimension.
  const double fine =
      4.0 * surface.area / std::pow(std::min(row_height, options.stitch_width), 2);
  if (nodes <= most_nodes && row <= most_in_a_row && fine <= most_fine_triangles) return;
  const double part = std::min({std::sqrt(most_nodes / nodes), most_in_a_row / row,
                                std::sqrt(most_fine_triangles / fine)});
  Problem problem;
  problem.code = "too-many-stitches";
  problem.message =
      "At this size and gauge the object is too large to knit: its openings are up to " +
      std::to_string(std::lround(std::min(row, 1e12))) +
      " stitches round, its surface takes about " +
      std::to_string(std::lround(std::min(2.0 * nodes, 1e15))) + " stitches.";
  problem.remedy =
      "Check the size or scale (lengths are millimetres after scaling) and the stitch's width "
      "and "
      "height. At " +
      percent(part) + " of this size or less it could be tried.";
  throw NotKnittable({problem});
}

// A row must fit between the openings, or there is nothing to knit but two rims.
void require_some_rows(const Surface& surface, const RemeshOptions& options) {
  double rim = 0.0;
  for (const BoundaryLoop& loop : surface.boundaries) rim += 0.5 * loop.length;
  const double rows = surface.area / (rim * 2.0 * options.stitch_height);
  if (rows >= 1.5) return;
  Problem problem;
  problem.code = "too-flat";
  problem.message =
      "There is room for less than two rows between the openings at this size and gauge.";
  problem.remedy = "Make the object larger, its openings smaller, or the stitches less high.";
  throw NotKnittable({problem});
}

KnitGraph peel_all(const Surface& surface, const std::vector<double>& time,
                   const RemeshOptions& options, const std::vector<int>& apart, RunContext* run,
                   Problems* warnings, FirstRows* first_rows) {
  Peeling peeling(surface, time, options, apart, run);
  while (!peeling.done()) {
    report(run, share_of_peeling * peeling.progress());
    peeling.step();
    if (first_rows && first_rows->wanted()) first_rows->offer(peeling.graph());
  }
  if (warnings) *warnings = peeling.warnings();
  return peeling.take_graph([&](double fraction) {
    report(run, share_of_peeling + (1.0 - share_of_peeling) * fraction);
  });
}

}  // namespace

KnitGraph remesh(const Surface& surface, const std::vector<double>& time,
                 const RemeshOptions& options, RunContext* run, Problems* warnings,
                 FirstRows* first_rows) {
  if (time.size() != surface.mesh.n_vertices())
    throw InvalidInput("remesh: one time per mesh vertex is needed");
  if (!(options.stitch_width > 0.0) || !(options.stitch_height > 0.0))
    throw InvalidInput("remesh: stitch width and height must be positive");
  require_sensible_size(surface, options);
  require_some_rows(surface, options);
  report(run, 0.0);
  std::vector<int> apart;
  std::optional<KnitGraph> graph;
  while (!graph) {
    try {
      graph = peel_all(surface, time, options, apart, run, warnings, first_rows);
    } catch (const NotInOneRow& failed) {
      // What cannot part or meet in one row does so in two, at the cost of some distortion (paper,
      // appendix A). Never twice for the same saddles, so this ends.
      apart.insert(apart.end(), failed.saddles.begin(), failed.saddles.end());
    }
  }
  report(run, 1.0);
  return std::move(*graph);
}

}  // namespace meshknit
