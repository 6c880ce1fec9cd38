#include "meshknit/surface/blob_shape.h"
#include "meshknit/surface/example_shapes.h"

namespace meshknit {
namespace {

using Eigen::Vector3d;

constexpr double edge_length = 6.0;  // mm

}  // namespace

ExampleShape trousers() {
  Blobs blobs;
  blobs.rounding = 6.0;
  // Two limbs side by side make a waist that is wider than deep.
  std::vector<TimedRim> rims = {{{{0.0, 0.0, 100.0}, Vector3d::UnitZ()}, -1.0}};
  for (const double side : {-1.0, 1.0}) {
    const Limb leg = {{{side * 17.0, 0.0, 125.0}, 33.0},
                      {{side * 20.0, 0.0, 50.0}, 37.0},
                      {{side * 34.0, 0.0, 0.0}, 30.0},
                      {{side * 40.0, 0.0, -110.0}, 23.0}};
    blobs.limbs.push_back(leg);
    rims.push_back({end_of(leg), 1.0});
  }
  return shape_of_blobs(blobs, rims, edge_length);
}

ExampleShape mitten() {
  Blobs blobs;
  blobs.rounding = 5.0;
  // Limbs side by side make a hand that is wider than thick.
  for (const double side : {-1.0, 0.0, 1.0})
    blobs.limbs.push_back({{{side * 16.0, 0.0, -20.0}, 17.0},
                           {{side * 14.0, 0.0, 55.0}, 16.0},
                           {{side * 19.0, 0.0, 105.0}, 20.0},
                           {{side * 19.0, 0.0, 165.0}, 19.0},
                           {{side * 15.0, 0.0, 205.0}, 15.0},
                           {{side * 8.0, 0.0, 235.0}, 8.0}});
  const Limb thumb = {
      {{14.0, 0.0, 75.0}, 15.0}, {{54.0, 0.0, 118.0}, 13.0}, {{66.0, 0.0, 160.0}, 11.0}};
  blobs.limbs.push_back(thumb);
  // The thumb's tip is reached about three quarters of the way to the fingertips.
  return shape_of_blobs(blobs,
                        {{{Vector3d::Zero(), -Vector3d::UnitZ()}, -1.0},
                         {{{0.0, 0.0, 231.0}, Vector3d::UnitZ()}, 1.0},
                         {end_of(thumb), 0.5}},
                        edge_length);
}

}  // namespace meshknit
