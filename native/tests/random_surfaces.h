#pragma once

#include <cstdint>

#include "meshknit/remesh/remesh.h"
#include "meshknit/surface/example_shapes.h"
#include "shapes.h"

namespace meshknit {

/// A surface that nobody drew, with the gauge to knit it at.
struct RandomSurface {
  ExampleShape shape;   ///< mm, with a time for every rim; no openings
  TimedShape timed;     ///< the same, checked, with its field
  RemeshOptions gauge;  ///< stitches 2.5 to 5 mm wide and 0.4 to 0.55 times as high
  int handles = 0;      ///< limbs that leave a limb and return to it: the genus
  int draws = 0;        ///< how many bodies were drawn until one was valid
};

/// A tree of bent tubes that branch two, three or four ways, in any order and direction, with
/// bumps and handles; most limbs end in a rim, some in a round tip. About 300 to 6,000 nodes at its
/// gauge, more often few than many, and at least eight stitches round the thinnest limb. Rims
/// start or end at random, at the first or last time or another one.
/// The same for the same seed, on every machine with the same rounding of sin, cos, exp and log.
/// Ensures: make_surface finds no fault at this gauge, the genus is the number of handles, and
/// check_constraints and check_time_field have no errors.
/// Throws: std::logic_error if none of 200 bodies is valid.
RandomSurface random_surface(std::uint32_t seed);

}  // namespace meshknit
