#include "meshknit/surface/blobs.h"

#include <algorithm>
#include <cmath>
#include <limits>

#include "meshknit/surface/segment.h"

namespace meshknit {
namespace {

using Eigen::Vector3d;

// Beyond this many roundings a part adds less than 1e-6 of itself to the sum.
constexpr double reach = 14.0;

BlobDistance distance_to_piece(const LimbStop& a, const LimbStop& b, const Vector3d& point) {
  const Vector3d along = b.at - a.at, from_a = point - a.at;
  const double t = nearest_along(a.at, b.at, point);
  const Vector3d away = from_a - t * along;
  const double length = away.norm();
  BlobDistance result;
  result.value = length - (a.radius + t * (b.radius - a.radius));
  if (length > 0.0) result.gradient = away / length;
  if (t > 0.0 && t < 1.0)
    result.gradient -= (b.radius - a.radius) / along.squaredNorm() * along;
  return result;
}

BlobDistance distance_to_limb(const Limb& limb, const Vector3d& point) {
  BlobDistance nearest = distance_to_piece(limb.front(), limb.front(), point);
  for (std::size_t i = 0; i + 1 < limb.size(); ++i) {
    const BlobDistance piece = distance_to_piece(limb[i], limb[i + 1], point);
    if (piece.value < nearest.value) nearest = piece;
  }
  return nearest;
}

// Too short a distance where the ellipsoid is flat, but its zero is right and it is never too
// steep.
BlobDistance distance_to_ellipsoid(const Ellipsoid& ellipsoid, const Vector3d& point) {
  const Vector3d scaled = (point - ellipsoid.centre).cwiseQuotient(ellipsoid.half_axes);
  const double shortest = ellipsoid.half_axes.minCoeff(), length = scaled.norm();
  BlobDistance result;
  result.value = (length - 1.0) * shortest;
  if (length > 0.0)
    result.gradient = shortest / length * scaled.cwiseQuotient(ellipsoid.half_axes);
  return result;
}

// A running sum of exp(-distance / rounding), scaled by its largest term so that it never
// overflows.
class SmoothUnion {
 public:
  explicit SmoothUnion(double rounding) : rounding_(rounding) {}

  void add(const BlobDistance& part) {
    if (part.value > least_ + reach * rounding_) return;
    if (part.value < least_) {
      const double scale = std::exp((part.value - least_) / rounding_);
      sum_ *= scale;
      gradient_ *= scale;
      least_ = part.value;
    }
    const double weight = std::exp((least_ - part.value) / rounding_);
    sum_ += weight;
    gradient_ += weight * part.gradient;
  }

  BlobDistance total() const { return {least_ - rounding_ * std::log(sum_), gradient_ / sum_}; }

 private:
  double rounding_;
  double least_ = std::numeric_limits<double>::infinity();
  double sum_ = 0.0;
  Vector3d gradient_ = Vector3d::Zero();
};

}  // namespace

BlobDistance distance_outside(const Blobs& blobs, const Vector3d& point) {
  SmoothUnion all(blobs.rounding);
  for (const Limb& limb : blobs.limbs) all.add(distance_to_limb(limb, point));
  for (const Ellipsoid& ellipsoid : blobs.ellipsoids)
    all.add(distance_to_ellipsoid(ellipsoid, point));
  return all.total();
}

BlobBounds bounds_of(const Blobs& blobs) {
  const double infinity = std::numeric_limits<double>::infinity();
  BlobBounds box{Vector3d::Constant(infinity), Vector3d::Constant(-infinity)};
  const auto hold = [&](const Vector3d& centre, const Vector3d& half) {
    box.low = box.low.cwiseMin(centre - half);
    box.high = box.high.cwiseMax(centre + half);
  };
  // Where n parts meet the body swells by up to rounding * log(n).
  const double parts = static_cast<double>(blobs.limbs.size() + blobs.ellipsoids.size());
  const double swelling = blobs.rounding * std::log(parts);
  for (const Limb& limb : blobs.limbs)
    for (const LimbStop& stop : limb) hold(stop.at, Vector3d::Constant(stop.radius + swelling));
  // The ellipsoid's own measure of distance is too short by up to longest / shortest axis.
  for (const Ellipsoid& e : blobs.ellipsoids)
    hold(e.centre, e.half_axes * (1.0 + swelling / e.half_axes.minCoeff()));
  return box;
}

Vector3d onto_surface(const Blobs& blobs, Vector3d point, const Vector3d& kept_plane) {
  constexpr int most_steps = 8;
  constexpr double close_enough = 1e-7;  // mm
  for (int step = 0; step < most_steps; ++step) {
    const BlobDistance at = distance_outside(blobs, point);
    if (std::abs(at.value) < close_enough) break;
    const Vector3d way = at.gradient - at.gradient.dot(kept_plane) * kept_plane;
    // Where the gradient nearly vanishes a full step would leap away.
    point -= at.value / std::max(way.squaredNorm(), 0.05) * way;
  }
  return point;
}

}  // namespace meshknit
