#include <cmath>

#include "meshknit/surface/blob_shape.h"
#include "meshknit/surface/example_shapes.h"

namespace meshknit {
namespace {

using Eigen::Vector3d;

constexpr double pi = 3.14159265358979323846;

}  // namespace

ExampleShape ring_torus() {
  constexpr double ring_radius = 45.0, tube_radius = 20.0, cap = 4.0;
  constexpr int stops = 48;
  Limb ring;
  for (int i = 0; i <= stops; ++i) {
    const double angle = 2.0 * pi * (i % stops) / stops;
    ring.push_back(
        {{ring_radius * std::sin(angle), 0.0, -ring_radius * std::cos(angle)}, tube_radius});
  }
  Blobs blobs;
  blobs.limbs.push_back(ring);
  // Planes that only graze the ring cut holes into its skin and leave the tube whole.
  const Vector3d top(0.0, 0.0, ring_radius + tube_radius - cap);
  return shape_of_blobs(
      blobs, {{{-top, -Vector3d::UnitZ()}, -1.0}, {{top, Vector3d::UnitZ()}, 1.0}}, 6.0);
}

ExampleShape teddy() {
  Blobs blobs;
  blobs.rounding = 4.0;
  blobs.ellipsoids = {{{0.0, 0.0, 60.0}, {34.0, 28.0, 40.0}},
                      {{0.0, -3.0, 116.0}, {32.0, 28.0, 28.0}},
                      {{0.0, -28.0, 109.0}, {13.0, 11.0, 10.0}}};
  // A point outside an opening's middle, which is then moved onto the surface.
  struct Tip {
    Vector3d beyond;
    double radius, time;
  };
  std::vector<Tip> tips;
  for (const double side : {-1.0, 1.0}) {
    blobs.ellipsoids.push_back({{side * 25.0, 0.0, 140.0}, {14.0, 9.0, 14.0}});
    blobs.limbs.push_back(
        {{{side * 22.0, 0.0, 82.0}, 13.0}, {{side * 66.0, -8.0, 62.0}, 12.0}});
    blobs.limbs.push_back(
        {{{side * 17.0, 0.0, 36.0}, 16.0}, {{side * 27.0, -4.0, -8.0}, 14.0}});
    tips.push_back({{side * 29.0, -5.0, -24.0}, 11.0, -1.0});
    tips.push_back({{side * 80.0, -11.0, 56.0}, 9.0, 0.7});
    tips.push_back({{side * 36.0, 0.0, 151.0}, 8.2, 1.0});
  }
  ExampleShape shape = shape_of_blobs(blobs, {}, 5.0);
  for (const Tip& tip : tips) {
    shape.times.push_back(
        {tip.time, Vector3d::Zero(), static_cast<int>(shape.openings.size())});
    shape.openings.push_back({onto_surface(blobs, tip.beyond), tip.radius});
  }
  return shape;
}

}  // namespace meshknit
