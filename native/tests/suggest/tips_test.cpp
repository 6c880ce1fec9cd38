#include "meshknit/suggest/tips.h"

#include <gtest/gtest.h>

#include <cmath>

#include "meshknit/suggest/eigenfunctions.h"
#include "meshknit/suggest/opening_radius.h"
#include "shapes.h"
#include "surface/test_meshes.h"

namespace meshknit {
namespace {

Surface surface_of(const MeshArrays& arrays) {
  return make_surface(arrays.vertices, arrays.faces);
}

TEST(Tips, TheTeddyHasThoseOfItsLimbs) {
  const ExampleShape teddy = example_shape("teddy");
  const Surface surface = make_surface(teddy.vertices, teddy.faces);
  const std::vector<Tip> tips = find_tips(surface.mesh);
  ASSERT_GE(tips.size(), 5u);
  // Two feet below, two arms at the sides, and an ear above.
  int feet = 0, arms = 0, ears = 0;
  for (std::size_t k = 0; k < 5; ++k) {
    const Eigen::Vector3d at = surface.mesh.point(TriangleMesh::VertexHandle(tips[k].vertex));
    feet += at.z() < 0.0;
    arms += std::abs(at.x()) > 60.0;
    ears += at.z() > 120.0;
  }
  EXPECT_EQ(feet, 2);
  EXPECT_EQ(arms, 2);
  EXPECT_EQ(ears, 1);
  EXPECT_TRUE(std::isinf(tips[0].prominence)) << "nothing is further out than the first";
  for (std::size_t k = 1; k < tips.size(); ++k)
    EXPECT_LE(tips[k].prominence, tips[k - 1].prominence);
}

TEST(Tips, ALimbThatEndsInAnOpeningHasNone) {
  const Surface surface = surface_of(tube());
  for (const Tip& tip : find_tips(surface.mesh)) EXPECT_LT(tip.prominence, 5.0);
}

TEST(Eigenfunctions, TheFirstOneOrdersALongTubeFromEndToEnd) {
  TubeShape shape;
  shape.length = 300.0;
  shape.along = 30;
  const Surface surface = surface_of(tube(shape));
  const std::vector<double> fiedler = low_eigenfunctions(surface.mesh, 1).front();
  // It is cos(pi z / length), whatever its sign.
  const auto at = [&](int ring) { return fiedler[ring * shape.around]; };
  for (int ring = 1; ring <= shape.along; ++ring)
    EXPECT_GT((at(ring) - at(ring - 1)) * (at(shape.along) - at(0)), 0.0) << ring;
  const double size = std::abs(at(0));
  EXPECT_NEAR(size, std::sqrt(2.0), 0.03) << "a cosine of mean square 1";
}

TEST(Eigenfunctions, AreTheSameTwiceAndStandAtRightAngles) {
  const Surface surface = surface_of(ball(30.0, 3));
  const auto once = low_eigenfunctions(surface.mesh, 3);
  EXPECT_EQ(once, low_eigenfunctions(surface.mesh, 3));
  for (int a = 0; a < 3; ++a)
    for (int b = 0; b < a; ++b) {
      double dot = 0.0;
      for (std::size_t v = 0; v < once[a].size(); ++v) dot += once[a][v] * once[b][v];
      EXPECT_LT(std::abs(dot), 0.05 * static_cast<double>(once[a].size()));
    }
}

TEST(OpeningRadius, IsThatOfARimOfADozenStitches) {
  const Surface surface = surface_of(ball(60.0, 4));
  const double radius = radius_for_opening(surface.mesh, 0, 1e9, 3.66, surface.area);
  // A circle of radius r on a ball of radius R is 2 pi R sin(r / R) long. Radii grow by an eighth.
  const double rim = 2.0 * 3.14159265 * 60.0 * std::sin(radius / 60.0);
  EXPECT_GE(rim, 0.98 * 12.0 * 3.66);
  EXPECT_LE(rim, 1.15 * 12.0 * 3.66);
}

TEST(OpeningRadius, ThereIsNoneOnABallOfAFewStitches) {
  const Surface surface = surface_of(ball(6.0, 3));
  EXPECT_EQ(radius_for_opening(surface.mesh, 0, 1e9, 3.66, surface.area), 0.0);
}

}  // namespace
}  // namespace meshknit
