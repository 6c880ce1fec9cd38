#include "meshknit/surface/refine_near.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

#include "surface/test_meshes.h"

namespace meshknit {
namespace {

std::vector<FaceOrigin> whole(const TriangleMesh& mesh) {
  std::vector<FaceOrigin> origin(mesh.n_faces());
  for (std::size_t f = 0; f < origin.size(); ++f) origin[f].face = static_cast<int>(f);
  return origin;
}

double least_angle(const TriangleMesh& mesh) {
  double least = 4.0;
  for (const auto h : mesh.halfedges())
    if (!mesh.is_boundary(h))
      least = std::min(least, static_cast<double>(mesh.calc_sector_angle(h)));
  return least;
}

double longest_edge(const TriangleMesh& mesh, OpenMesh::FaceHandle face) {
  double longest = 0.0;
  for (const auto e : mesh.fe_range(face))
    longest = std::max(longest, mesh.calc_edge_length(e));
  return longest;
}

double area(const TriangleMesh& mesh) {
  double sum = 0.0;
  for (const auto f : mesh.faces()) sum += mesh.calc_face_area(f);
  return sum;
}

TEST(RefineNear, MakesTrianglesSmallRoundThePlaceOnly) {
  TriangleMesh mesh = half_edges(box({100.0, 100.0, 100.0}));
  std::vector<FaceOrigin> origin = whole(mesh);
  const SurfacePoint place = nearest_face(mesh, {30.0, 40.0, 100.0});
  refine_near(mesh, origin, place, 10.0, 1.0);
  int far_and_large = 0;
  for (const auto f : mesh.faces()) {
    const auto corner = corners_of(mesh, f.idx());
    const double off = (nearest_in_triangle(corner, place.position) - place.position).norm();
    if (off <= 10.0) {
      EXPECT_LE(longest_edge(mesh, f), 1.0);
    }
    far_and_large += off > 60.0 && longest_edge(mesh, f) > 20.0;
  }
  EXPECT_GT(far_and_large, 5);
  EXPECT_NEAR(area(mesh), 60000.0, 1e-6);
  // The triangles of a box have 45 degrees; Rivara's bound is half the least angle.
  EXPECT_GE(least_angle(mesh), 3.141592653589793 / 8 - 1e-9);
}

TEST(RefineNear, LeavesTheOtherSideOfASheetAlone) {
  // A box 2 mm thick: within 20 mm of its middle lies the other side, but the way to it round
  // the edge is 50 mm.
  TriangleMesh mesh = half_edges(box({100.0, 100.0, 2.0}));
  std::vector<FaceOrigin> origin = whole(mesh);
  refine_near(mesh, origin, nearest_face(mesh, {50.0, 50.0, 2.0}), 20.0, 2.0);
  int below = 0;
  for (const auto f : mesh.faces()) below += mesh.calc_face_centroid(f).z() < 1e-9;
  EXPECT_LT(below, 40);
}

TEST(RefineNear, KnowsWhereEveryPieceComesFrom) {
  const MeshArrays arrays = box({40.0, 30.0, 20.0});
  TriangleMesh mesh = half_edges(arrays);
  std::vector<FaceOrigin> origin = whole(mesh);
  origin[2].opening = 7;
  const TriangleMesh before = mesh;
  refine_near(mesh, origin, nearest_face(mesh, {40.0, 30.0, 20.0}), 15.0, 3.0);
  ASSERT_EQ(origin.size(), mesh.n_faces());
  ASSERT_GT(mesh.n_faces(), 100u);
  for (const auto f : mesh.faces()) {
    const auto corner = corners_of(before, origin[f.idx()].face);
    const Eigen::Vector3d middle = mesh.calc_face_centroid(f);
    EXPECT_LT((nearest_in_triangle(corner, middle) - middle).norm(), 1e-9);
    EXPECT_EQ(origin[f.idx()].opening, origin[f.idx()].face == 2 ? 7 : -1);
  }
}

}  // namespace
}  // namespace meshknit
