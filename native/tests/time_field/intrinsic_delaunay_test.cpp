#include "meshknit/time_field/intrinsic_delaunay.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <map>
#include <utility>

#include "meshknit/time_field/laplacian.h"
#include "surface/test_meshes.h"

namespace meshknit {
namespace {

constexpr double kPi = 3.141592653589793;

// A tube of slivers: 8 mm wide and 400 mm high quads on a cone, jittered.
TriangleMesh thin_mesh() {
  TubeShape shape;
  shape.around = 40;
  shape.along = 6;
  shape.length = 2400.0;
  shape.radius = [](double z) { return 50.0 + 0.01 * z; };
  shape.jitter = 0.4;
  return half_edges(tube(shape));
}

double angle_opposite(const std::array<double, 3>& lengths, int k) {
  return std::atan2(1.0, cotangent_opposite(lengths, k));
}

// Inner sides whose two opposite angles sum to more than pi: their cotangents sum to less than
// nothing.
int obtuse_pairs(const TriangleMesh& mesh, const IntrinsicTriangles& triangles) {
  std::map<std::pair<int, int>, double> sum;
  for (std::size_t f = 0; f < triangles.corners.size(); ++f)
    for (int k = 0; k < 3; ++k) {
      const int a = triangles.corners[f][k], b = triangles.corners[f][(k + 1) % 3];
      sum[std::minmax(a, b)] += cotangent_opposite(triangles.lengths[f], k);
    }
  int obtuse = 0;
  for (const auto& [ends, cotangents] : sum) {
    const bool rim = mesh.is_boundary(OpenMesh::VertexHandle(ends.first)) &&
                     mesh.is_boundary(OpenMesh::VertexHandle(ends.second));
    obtuse += !rim && cotangents < -1e-6 ? 1 : 0;
  }
  return obtuse;
}

TEST(IntrinsicDelaunay, FlipsTheLongDiagonalOfAKite) {
  // A kite with its long diagonal drawn from (-4, 0) to (4, 0); the short one goes from (0, -3)
  // to (0, 3).
  TriangleMesh kite;
  const auto left = kite.add_vertex({-4.0, 0.0, 0.0}), low = kite.add_vertex({0.0, -3.0, 0.0}),
             right = kite.add_vertex({4.0, 0.0, 0.0}), high = kite.add_vertex({0.0, 3.0, 0.0});
  kite.add_face(left, low, right);
  kite.add_face(left, right, high);
  const IntrinsicTriangles triangles = intrinsic_delaunay(kite);
  for (std::size_t f = 0; f < 2; ++f)
    for (int k = 0; k < 3; ++k) {
      const int a = triangles.corners[f][k], b = triangles.corners[f][(k + 1) % 3];
      const bool diagonal =
          (a == low.idx() && b == high.idx()) || (a == high.idx() && b == low.idx());
      // The rims are 3-4-5 triangles' long sides, the new diagonal is 6.
      EXPECT_NEAR(triangles.lengths[f][k], diagonal ? 6.0 : 5.0, 1e-6);
    }
}

TEST(IntrinsicDelaunay, KeepsTheShapeAndLeavesNoObtusePairs) {
  const TriangleMesh mesh = thin_mesh();
  const IntrinsicTriangles before = side_lengths(mesh), after = intrinsic_delaunay(mesh);
  ASSERT_GT(obtuse_pairs(mesh, before), 50) << "the shape must be hard for plain cotangents";
  EXPECT_EQ(obtuse_pairs(mesh, after), 0);
  ASSERT_EQ(after.corners.size(), before.corners.size());
  // Flips do not change the angle round an inner vertex (the cone angle): that is the shape. A
  // corner's angle is opposite to the side that starts at the next corner.
  std::vector<double> cone_before(mesh.n_vertices(), 0.0), cone_after(mesh.n_vertices(), 0.0);
  for (std::size_t f = 0; f < before.corners.size(); ++f)
    for (int k = 0; k < 3; ++k) {
      cone_before[before.corners[f][k]] += angle_opposite(before.lengths[f], (k + 1) % 3);
      cone_after[after.corners[f][k]] += angle_opposite(after.lengths[f], (k + 1) % 3);
    }
  for (std::size_t v = 0; v < cone_before.size(); ++v)
    EXPECT_NEAR(cone_after[v], cone_before[v], 1e-5) << "vertex " << v;
}

TEST(LaplacianWeights, ArePositiveOnThinTriangles) {
  for (const LaplacianKind kind : {LaplacianKind::intrinsic_delaunay,
                                   LaplacianKind::clamped_cotangent, LaplacianKind::uniform})
    for (const EdgeWeight& w : laplacian_weights(thin_mesh(), kind)) {
      EXPECT_GT(w.weight, 0.0);
      EXPECT_LT(w.a, w.b);
    }
}

TEST(LaplacianWeights, DelaunayWeightsOfAPlateAreThoseOfItsSquares) {
  // In a grid of squares cut by diagonals both angles opposite to a diagonal are right ones, so
  // diagonals weigh nothing; an inner side has two angles of 45 degrees opposite: (1 + 1) / 2.
  const TriangleMesh plate = half_edges(grid(4, 4, 5.0, [](int, int) { return false; }));
  for (const EdgeWeight& w : laplacian_weights(plate, LaplacianKind::intrinsic_delaunay)) {
    const bool rim = plate.is_boundary(OpenMesh::VertexHandle(w.a)) &&
                     plate.is_boundary(OpenMesh::VertexHandle(w.b));
    const bool diagonal = w.b - w.a == 6 || w.b - w.a == 4;
    if (rim) continue;
    EXPECT_NEAR(w.weight, diagonal ? 0.0 : 1.0, 1e-6);
  }
}

TEST(Cotangent, OfARightIsoscelesTriangle) {
  const std::array<double, 3> sides = {1.0, 1.0, std::sqrt(2.0)};
  EXPECT_NEAR(cotangent_opposite(sides, 0), 1.0, 1e-12);
  EXPECT_NEAR(cotangent_opposite(sides, 2), 0.0, 1e-12);
  EXPECT_NEAR(angle_opposite({2.0, 2.0, 2.0}, 0), kPi / 3, 1e-12);
}

}  // namespace
}  // namespace meshknit
