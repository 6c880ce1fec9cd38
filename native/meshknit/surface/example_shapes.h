#pragma once

#include <Eigen/Core>
#include <string>
#include <vector>

#include "meshknit/surface/openings.h"
#include "meshknit/surface/triangle_mesh.h"

namespace meshknit {

/// When a boundary or the rim of an opening is knit.
struct TimeMark {
  double time = 0.0;                                        ///< in [-1, 1]
  Eigen::Vector3d boundary_near = Eigen::Vector3d::Zero();  ///< mm; unless `opening` says which
  int opening = -1;                                         ///< index into the openings, or -1
};

/// A shape to learn and to test with: arrays in mm, faces anticlockwise seen from outside, and
/// what a marks file would say: where to open it and when its rims are knit.
struct ExampleShape {
  VertexArray vertices;
  FaceArray faces;
  std::vector<TimeMark> times;
  std::vector<OpeningMark> openings;
};

/// The same shape, `size` times as large, with its marks.
ExampleShape scaled(ExampleShape shape, double size);

/// Upright tube from z = 0 (start) to z = length (end).
ExampleShape straight_tube(double radius = 30.0, double length = 120.0);

/// Upright truncated cone from z = 0 (start) to z = height (end).
ExampleShape cone(double start_radius = 45.0, double end_radius = 20.0, double height = 120.0);

/// Two straight legs joined by a circular bend, in the xz plane.
/// Requires: 0 <= degrees <= 150.
ExampleShape bent_tube(double degrees = 90.0, double radius = 25.0, double leg = 50.0);

/// A sock, cuff (start) up, toe (end, a small opening) along x: the leg narrows to the ankle,
/// the heel is wider and bends, the foot narrows to the toe.
ExampleShape sock();

/// A trunk that splits into limbs side by side, upright, all rims flat: from the trunk (start)
/// to two or three limbs (ends).
ExampleShape two_way_split();
ExampleShape three_way_split();

/// The same shapes knit the other way round: limbs (starts) that merge into a trunk (end).
ExampleShape two_way_merge();
ExampleShape three_way_merge();

/// Trousers, waist (start) up, both hems (ends) down.
ExampleShape trousers();

/// A mitten, cuff (start) down, open at the fingertips (end) and, earlier, at the thumb's tip.
ExampleShape mitten();

/// An upright ring of round cross-section with a hole in its skin at the bottom (start) and one
/// at the top (end): genus 1.
ExampleShape ring_torus();

/// A closed teddy bear with openings on feet (starts), hands, and, last, ears (ends).
ExampleShape teddy();

/// Names that example_shape() knows, and the shape of a name with its default sizes.
/// Throws: InvalidInput for an unknown name.
std::vector<std::string> example_shape_names();
ExampleShape example_shape(const std::string& name);

}  // namespace meshknit
