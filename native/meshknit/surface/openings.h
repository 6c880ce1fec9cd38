#pragma once

#include <Eigen/Core>

namespace meshknit {

/// An opening in the surface: everything within a geodesic distance of a point.
struct OpeningMark {
  Eigen::Vector3d at;  ///< mm, on or near the surface
  double radius;       ///< mm along the surface
};

}  // namespace meshknit
