#pragma once

#include <Eigen/Core>
#include <algorithm>

namespace meshknit {

/// How far along the way from a to b the point nearest to p lies, 0 to 1; 0 if a and b are one.
inline double nearest_along(const Eigen::Vector3d& a, const Eigen::Vector3d& b,
                            const Eigen::Vector3d& p) {
  const Eigen::Vector3d ab = b - a;
  const double squared = ab.squaredNorm();
  return squared > 0.0 ? std::clamp((p - a).dot(ab) / squared, 0.0, 1.0) : 0.0;
}

}  // namespace meshknit
