#pragma once

#include <Eigen/Core>
#include <string>
#include <vector>

#include "meshknit/surface/triangle_mesh.h"

namespace meshknit {

/// A shape to learn and to test with: arrays in mm, faces anticlockwise seen from outside, and
/// a point near the boundary where knitting starts and near the one where it ends.
struct ExampleShape {
  VertexArray vertices;
  FaceArray faces;
  Eigen::Vector3d start = Eigen::Vector3d::Zero();
  Eigen::Vector3d end = Eigen::Vector3d::Zero();
};

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

/// Names that example_shape() knows, and the shape of a name with its default sizes.
/// Throws: InvalidInput for an unknown name.
std::vector<std::string> example_shape_names();
ExampleShape example_shape(const std::string& name);

}  // namespace meshknit
