#include "lantern.h"

#include "meshknit/surface/blob_shape.h"

namespace meshknit {

ExampleShape lantern() {
  constexpr double trunk = 24.0, half = 18.0, quarter = 13.0;  // radii, mm
  constexpr double aside = 38.0;
  Blobs blobs;
  blobs.rounding = 4.0;
  const Limb stem = {{{0.0, 0.0, 40.0}, trunk}, {{0.0, 0.0, 0.0}, trunk}};
  const Limb crown = {{{0.0, 0.0, 330.0}, trunk}, {{0.0, 0.0, 370.0}, trunk}};
  blobs.limbs = {stem, crown};
  for (const double side : {-aside, aside}) {
    blobs.limbs.push_back(
        {{{0.0, 0.0, 40.0}, half}, {{side, 0.0, 85.0}, half}, {{side, 0.0, 120.0}, half}});
    blobs.limbs.push_back(
        {{{0.0, side, 250.0}, half}, {{0.0, side, 285.0}, half}, {{0.0, 0.0, 330.0}, half}});
    for (const double depth : {-aside, aside})
      blobs.limbs.push_back({{{side, 0.0, 120.0}, quarter},
                             {{side, depth, 165.0}, quarter},
                             {{side, depth, 205.0}, quarter},
                             {{0.0, depth, 250.0}, quarter}});
  }
  return shape_of_blobs(blobs, {{end_of(stem), -1.0}, {end_of(crown), 1.0}}, 6.0);
}

}  // namespace meshknit
