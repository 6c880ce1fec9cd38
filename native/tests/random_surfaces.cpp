#include "random_surfaces.h"

#include <algorithm>
#include <cmath>
#include <optional>
#include <stdexcept>
#include <string>

#include "meshknit/core/error.h"
#include "random_body.h"

namespace meshknit {
namespace {

constexpr double pi = 3.14159265358979323846;
constexpr int most_draws = 200;
constexpr double fewest_nodes = 300.0, most_nodes = 6000.0;
constexpr double thinnest_limb = 0.2;  // of the trunk: with thinner ones the body is too large
constexpr double fewest_stitches_round = 8.0;

// The first rim starts and the second ends; the others do either. A third of the shapes has other
// times than the first and the last.
std::vector<double> random_times(Lots& lots, std::size_t rims) {
  const bool spread = lots.chance(0.33), upside_down = lots.chance(0.5);
  std::vector<double> times;
  for (std::size_t i = 0; i < rims; ++i) {
    const bool starts = i == 0 || (i > 1 && lots.chance(0.3));
    double time = starts ? -1.0 : 1.0;
    if (spread && i > 1) time = starts ? lots.between(-1.0, -0.5) : lots.between(0.5, 1.0);
    times.push_back(upside_down ? -time : time);
  }
  return times;
}

double area_of(const ExampleShape& shape) {
  double area = 0.0;
  for (Eigen::Index f = 0; f < shape.faces.rows(); ++f) {
    const auto corner = [&](int k) -> Eigen::Vector3d {
      return shape.vertices.row(shape.faces(f, k)).transpose();
    };
    area += 0.5 * (corner(1) - corner(0)).cross(corner(2) - corner(0)).norm();
  }
  return area;
}

std::optional<RandomSurface> draw(Lots& lots) {
  const RandomBody body = random_body(lots);
  if (body.thinnest < thinnest_limb) return std::nullopt;
  const std::vector<double> times = random_times(lots, body.rims.size());
  RandomSurface result;
  result.handles = body.handles;
  std::vector<TimedRim> rims;
  for (std::size_t i = 0; i < times.size(); ++i) rims.push_back({body.rims[i], times[i]});
  try {
    result.shape = shape_of_blobs(body.blobs, rims, std::min(0.85 * body.thinnest, 0.5));
  } catch (const InvalidInput&) {
    return std::nullopt;  // a plane that takes the whole body with it
  }

  result.gauge.stitch_width = lots.between(2.5, 5.0);
  result.gauge.stitch_height = result.gauge.stitch_width * lots.between(0.4, 0.55);
  const double node = result.gauge.stitch_width * 2.0 * result.gauge.stitch_height;
  // The square prefers small numbers.
  const double luck = lots.between(0.0, 1.0);
  const double nodes = fewest_nodes * std::pow(most_nodes / fewest_nodes, luck * luck);
  const double area = area_of(result.shape);
  const double least =
      fewest_stitches_round * result.gauge.stitch_width / (2.0 * pi * body.thinnest);
  const double size = std::max(least, std::sqrt(nodes * node / area));
  if (size * size * area > 1.02 * most_nodes * node) return std::nullopt;
  result.shape = scaled(std::move(result.shape), size);

  SurfaceOptions options;
  options.stitch_width = result.gauge.stitch_width;
  Surface& surface = result.timed.surface;
  surface = make_surface(result.shape.vertices, result.shape.faces, options);
  if (!surface.problems.empty() || surface.genus != body.handles ||
      surface.boundaries.size() != body.rims.size())
    return std::nullopt;
  const std::vector<TimeConstraint> constraints = time_constraints(surface, result.shape);
  if (!check_constraints(surface, constraints).empty()) return std::nullopt;
  try {
    result.timed.time = solve_time_field(surface, constraints).time;
  } catch (const NotKnittable&) {
    return std::nullopt;  // a time that makes a rim neither start nor end
  }
  return result;
}

}  // namespace

RandomSurface random_surface(std::uint32_t seed) {
  for (int attempt = 0; attempt < most_draws; ++attempt) {
    Lots lots(seed * most_draws + static_cast<std::uint32_t>(attempt));
    if (std::optional<RandomSurface> found = draw(lots)) {
      found->draws = attempt + 1;
      return *std::move(found);
    }
  }
  throw std::logic_error("no valid surface for seed " + std::to_string(seed));
}

}  // namespace meshknit
