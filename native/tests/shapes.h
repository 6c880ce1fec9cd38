#pragma once

#include <string>
#include <vector>

#include "meshknit/remesh/remesh.h"
#include "meshknit/surface/example_shapes.h"
#include "meshknit/surface/surface.h"
#include "meshknit/time_field/time_field.h"

namespace meshknit {

/// A shape of the tests with its solved time field.
struct TimedShape {
  Surface surface;
  std::vector<double> time;  ///< per mesh vertex
};

/// The shapes that every stage must cope with, all tubes: those of example_shapes.h and
///  - "bent_tube_30", "_60", "_120": bends of other angles;
///  - "widening_cone": the cone knit from its narrow end;
///  - "bottle": a body, a shoulder that narrows fast, a neck;
///  - "hourglass": narrow in the middle, so that it is a saddle everywhere;
///  - "tilted_cut": a straight tube whose upper rim slants by 30 degrees;
///  - "wobbly_tube": its axis, its width and its cross-section wander at random.
std::vector<std::string> shape_names();

/// How much larger and smaller than drawn the shapes are tried: about 400, 1,800 and 7,000
/// nodes.
inline constexpr double shape_sizes[] = {0.5, 1.0, 2.0};

/// The vertices of a named shape, `size` times as large as drawn. Throws: InvalidInput for an
/// unknown name.
ExampleShape arrays_of_shape(const std::string& name, double size = 1.0);

/// The shape with its openings cut; their times go to the rims. Throws: NotKnittable if one cannot
/// be cut, or is too small for stitches this wide.
ExampleShape opened(ExampleShape shape, double stitch_width = 3.66);

/// What a shape's marks say about its surface. Requires: a shape without openings.
std::vector<TimeConstraint> time_constraints(const Surface& surface, const ExampleShape& shape);

/// Surface and time field. Throws: NotKnittable if it has none, or a boundary is too short for
/// stitches this wide.
TimedShape timed(const ExampleShape& shape, double stitch_width = 3.66);
TimedShape shape_named(const std::string& name, double size = 1.0);

/// Stitches `times` as wide and high as the default ones.
RemeshOptions gauge(double times);

/// The smallest angle of a shape's triangles, degrees.
double smallest_angle(const ExampleShape& shape);

/// The same shape with its vertices and faces in another order.
ExampleShape shuffled(const ExampleShape& shape, unsigned seed);

}  // namespace meshknit
