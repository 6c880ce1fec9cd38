#include "meshknit/surface/blob_shape.h"
#include "meshknit/surface/example_shapes.h"

namespace meshknit {
namespace {

constexpr double edge_length = 6.0;  // mm

// An upright trunk below limbs that lean apart and then rise straight, side by side along x.
ExampleShape branching(const std::vector<double>& limb_x, double limb_radius,
                       double trunk_radius, double trunk_time) {
  constexpr double trunk = 70.0, rise = 45.0, height = 150.0;
  Blobs blobs;
  blobs.rounding = 5.0;
  const Limb stem = {{{0.0, 0.0, trunk}, trunk_radius}, {{0.0, 0.0, 0.0}, trunk_radius}};
  blobs.limbs.push_back(stem);
  std::vector<TimedRim> rims = {{end_of(stem), trunk_time}};
  for (const double x : limb_x) {
    const Limb limb = {{{0.35 * x, 0.0, trunk}, limb_radius},
                       {{x, 0.0, trunk + rise}, limb_radius},
                       {{x, 0.0, height}, limb_radius}};
    blobs.limbs.push_back(limb);
    rims.push_back({end_of(limb), -trunk_time});
  }
  return shape_of_blobs(blobs, rims, edge_length);
}

}  // namespace

ExampleShape two_way_split() { return branching({-30.0, 30.0}, 17.0, 28.0, -1.0); }
ExampleShape three_way_split() { return branching({-52.0, 0.0, 52.0}, 16.0, 32.0, -1.0); }
ExampleShape two_way_merge() { return branching({-30.0, 30.0}, 17.0, 28.0, 1.0); }
ExampleShape three_way_merge() { return branching({-52.0, 0.0, 52.0}, 16.0, 32.0, 1.0); }

}  // namespace meshknit
