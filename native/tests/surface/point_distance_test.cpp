#include "meshknit/surface/point_distance.h"

#include <gtest/gtest.h>

#include <cmath>
#include <limits>

#include "surface/exact_point_distances.h"
#include "surface/test_meshes.h"

namespace meshknit {
namespace {

constexpr double infinity = std::numeric_limits<double>::infinity();

TEST(DistanceFrom, IsStraightInAPlane) {
  const TriangleMesh mesh = half_edges(grid(10, 8, 5.0, [](int, int) { return false; }));
  const SurfacePoint source = nearest_face(mesh, {18.0, 21.5, 3.0});
  EXPECT_NEAR(source.position.z(), 0.0, 1e-12);
  const std::vector<double> distance = distance_from(mesh, source, infinity);
  for (const auto v : mesh.vertices())
    EXPECT_NEAR(distance[v.idx()], (mesh.point(v) - source.position).norm(), 1e-9);
}

TEST(DistanceFrom, GoesRoundTheCornerOfAHole) {
  // A square hole from (20, 20) to (40, 40): from (10, 10) the way to (40, 44) bends at
  // (20, 40), the way to (50, 20) is straight.
  const MeshArrays arrays =
      grid(30, 30, 2.0, [](int x, int y) { return x >= 10 && x < 20 && y >= 10 && y < 20; });
  const TriangleMesh mesh = half_edges(arrays);
  const std::vector<double> distance =
      distance_from(mesh, nearest_face(mesh, {10.0, 10.0, 0.0}), infinity);
  const auto at = [](int column, int row) { return row * 31 + column; };
  const double bent = std::hypot(10.0, 30.0) + std::hypot(20.0, 4.0);
  EXPECT_NEAR(distance[at(20, 22)], bent, 0.01 * bent);
  EXPECT_NEAR(distance[at(25, 10)], std::hypot(40.0, 10.0), 1e-6);
}

TEST(DistanceFrom, KnowsNothingBeyondTheLimit) {
  const TriangleMesh mesh = half_edges(grid(10, 10, 2.0, [](int, int) { return false; }));
  const SurfacePoint source = nearest_face(mesh, {10.0, 10.0, 0.0});
  const std::vector<double> distance = distance_from(mesh, source, 6.0);
  for (const auto v : mesh.vertices()) {
    const double straight = (mesh.point(v) - source.position).norm();
    EXPECT_EQ(std::isfinite(distance[v.idx()]), straight <= 6.0) << straight;
  }
}

TEST(DistanceFrom, IsNearTheExactDistanceOnABentSurface) {
  // A wavy tube with edges of a sixth of the distance: twice as long as openings use.
  TubeShape shape;
  shape.jitter = 0.3;
  shape.around = 36;
  shape.along = 30;
  shape.radius = [](double z) { return 20.0 + 3.0 * std::sin(0.2 * z); };
  const MeshArrays arrays = tube(shape);
  const TriangleMesh mesh = half_edges(arrays);
  const SurfacePoint source = nearest_face(mesh, {20.0, 1.0, 47.0});
  const std::vector<double> distance = distance_from(mesh, source, 25.0);
  std::vector<SurfacePoint> places;
  std::vector<double> ours;
  for (const auto v : mesh.vertices()) {
    if (!(distance[v.idx()] > 15.0 && distance[v.idx()] <= 25.0)) continue;
    places.push_back({mesh.cvf_begin(v)->idx(), mesh.point(v)});
    ours.push_back(distance[v.idx()]);
  }
  ASSERT_GT(places.size(), 50u);
  const std::vector<double> exact = exact_distances_from(arrays, source, places);
  for (std::size_t i = 0; i < places.size(); ++i) EXPECT_NEAR(ours[i] / exact[i], 1.0, 0.02);
}

TEST(LevelCrossing, IsWhereACircleCutsALine) {
  // An edge from (3, 4) to (3, 12), seen from the origin: a circle of radius 9 meets it at
  // y = sqrt(81 - 9).
  const double t = level_crossing(5.0, std::hypot(3.0, 12.0), 8.0, 9.0);
  EXPECT_NEAR(4.0 + 8.0 * t, std::sqrt(72.0), 1e-12);
}

}  // namespace
}  // namespace meshknit
