#include "meshknit/surface/blobs.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

#include "surface/test_meshes.h"

namespace meshknit {
namespace {

using Eigen::Vector3d;

Blobs cone_and_ball() {
  Blobs blobs;
  blobs.limbs = {{{{0.0, 0.0, 0.0}, 12.0}, {{0.0, 0.0, 40.0}, 6.0}, {{25.0, 0.0, 60.0}, 5.0}}};
  blobs.ellipsoids = {{{15.0, 4.0, 0.0}, {10.0, 14.0, 8.0}}};
  return blobs;
}

Vector3d random_point(Jitter& jitter) {
  return {45.0 * jitter.next(), 30.0 * jitter.next(), 30.0 + 60.0 * jitter.next()};
}

TEST(Blobs, ALoneBallIsABall) {
  Blobs ball;
  ball.limbs = {{{{1.0, 2.0, 3.0}, 10.0}}};
  EXPECT_NEAR(distance_outside(ball, {1.0, 2.0, 18.0}).value, 5.0, 1e-12);
  EXPECT_NEAR(distance_outside(ball, {1.0, 2.0, 3.0}).value, -10.0, 1e-12);
}

TEST(Blobs, TheGradientIsTheSlopeOfTheDistance) {
  const Blobs blobs = cone_and_ball();
  Jitter jitter(3);
  constexpr double h = 1e-5;
  for (int i = 0; i < 200; ++i) {
    const Vector3d point = random_point(jitter);
    const BlobDistance at = distance_outside(blobs, point);
    for (int axis = 0; axis < 3; ++axis) {
      const Vector3d step = h * Vector3d::Unit(axis);
      const double slope = (distance_outside(blobs, point + step).value -
                            distance_outside(blobs, point - step).value) /
                           (2.0 * h);
      EXPECT_NEAR(at.gradient[axis], slope, 1e-4);
    }
  }
}

TEST(Blobs, NoPointIsSaidToBeFurtherAwayThanTheSlopeAllows) {
  // The lattice skips points on this promise.
  const Blobs blobs = cone_and_ball();
  Jitter jitter(5);
  for (int i = 0; i < 500; ++i) {
    const Vector3d a = random_point(jitter), b = random_point(jitter);
    EXPECT_LE(std::abs(distance_outside(blobs, a).value - distance_outside(blobs, b).value),
              steepest_slope * (a - b).norm());
  }
}

TEST(Blobs, PartsThatMeetSwellInsideTheirBox) {
  const Blobs blobs = cone_and_ball();
  const BlobBounds box = bounds_of(blobs);
  Jitter jitter(9);
  for (int i = 0; i < 500; ++i) {
    const Vector3d found = onto_surface(blobs, random_point(jitter));
    if (std::abs(distance_outside(blobs, found).value) > 1e-6) continue;
    EXPECT_TRUE((found.array() >= box.low.array()).all());
    EXPECT_TRUE((found.array() <= box.high.array()).all());
  }
  // Between two equal balls that touch the body is rounding * log(2) thicker than either.
  Blobs pair;
  pair.limbs = {{{{-10.0, 0.0, 0.0}, 10.0}}, {{{10.0, 0.0, 0.0}, 10.0}}};
  EXPECT_NEAR(distance_outside(pair, Vector3d::Zero()).value, -4.0 * std::log(2.0), 1e-12);
}

TEST(Blobs, APointNearTheSurfaceFindsItAndKeepsToAPlane) {
  const Blobs blobs = cone_and_ball();
  const Vector3d up = Vector3d::UnitZ(), start(0.0, 13.0, 22.0);
  const Vector3d found = onto_surface(blobs, start, up);
  EXPECT_NEAR(distance_outside(blobs, found).value, 0.0, 1e-6);
  EXPECT_NEAR(found.z(), 22.0, 1e-12);
  EXPECT_NEAR(distance_outside(blobs, onto_surface(blobs, start)).value, 0.0, 1e-6);
}

}  // namespace
}  // namespace meshknit
