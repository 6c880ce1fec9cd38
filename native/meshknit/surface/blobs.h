#pragma once

#include <Eigen/Core>
#include <vector>

namespace meshknit {

/// A stop on the centre line of a limb, mm.
struct LimbStop {
  Eigen::Vector3d at = Eigen::Vector3d::Zero();
  double radius = 0.0;
};

/// A round limb: its stops are joined by straight pieces along which the radius changes evenly,
/// and both ends are round. The same first and last stop make a ring.
using Limb = std::vector<LimbStop>;

/// An ellipsoid along the axes, mm.
struct Ellipsoid {
  Eigen::Vector3d centre = Eigen::Vector3d::Zero();
  Eigen::Vector3d half_axes = Eigen::Vector3d::Ones();
};

/// A body of limbs and ellipsoids that flow into each other ("metaballs"): the points where the
/// depth below all parts together, -rounding log(sum exp(-distance / rounding)), is negative.
struct Blobs {
  std::vector<Limb> limbs;
  std::vector<Ellipsoid> ellipsoids;
  double rounding = 4.0;  ///< mm, about half the radius of the fillet between two parts
};

/// How far outside the body a point lies (negative inside; near the surface about mm), and which
/// way it grows.
struct BlobDistance {
  double value = 0.0;
  Eigen::Vector3d gradient = Eigen::Vector3d::Zero();
};

/// Requires: at least one part, rounding > 0, radii and half axes > 0, and radii that change by
/// less than the distance between their stops.
/// Ensures: the value of two points differs by no more than steepest_slope times their distance.
BlobDistance distance_outside(const Blobs& blobs, const Eigen::Vector3d& point);
inline constexpr double steepest_slope = 1.5;

/// A box that holds the surface.
struct BlobBounds {
  Eigen::Vector3d low, high;
};
BlobBounds bounds_of(const Blobs& blobs);

/// The surface point that Newton's method finds from a point near the surface, by steps along
/// the gradient; with a unit normal `kept_plane`, steps stay in the plane through the point.
Eigen::Vector3d onto_surface(const Blobs& blobs, Eigen::Vector3d point,
                             const Eigen::Vector3d& kept_plane = Eigen::Vector3d::Zero());

}  // namespace meshknit
