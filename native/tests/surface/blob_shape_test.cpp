#include "meshknit/surface/blob_shape.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

#include "meshknit/core/error.h"
#include "meshknit/surface/surface.h"

namespace meshknit {
namespace {

using Eigen::Vector3d;

constexpr double pi = 3.14159265358979323846;

Surface surface_of(const BlobMesh& mesh) { return make_surface(mesh.vertices, mesh.faces); }

Blobs one_limb(const Limb& limb) {
  Blobs blobs;
  blobs.limbs = {limb};
  return blobs;
}

const Limb stick = {{{0.0, 0.0, 0.0}, 20.0}, {{0.0, 0.0, 100.0}, 20.0}};
const RimCut below{{0.0, 0.0, 10.0}, -Vector3d::UnitZ()};
const RimCut above{{0.0, 0.0, 90.0}, Vector3d::UnitZ()};

// Two legs and an arch, upside down: both legs reach below z = 0.
Limb arch() {
  return {{{-40.0, 0.0, -20.0}, 12.0},
          {{-40.0, 0.0, 40.0}, 12.0},
          {{40.0, 0.0, 40.0}, 12.0},
          {{40.0, 0.0, -20.0}, 12.0}};
}

TEST(BlobShape, ABallIsClosedAndRound) {
  const Blobs ball = one_limb({{Vector3d::Zero(), 30.0}});
  const BlobMesh mesh = mesh_of_blobs(ball, {}, 5.0);
  const Surface surface = surface_of(mesh);
  // Closed meshes have too few boundaries to be knit, and no other fault.
  ASSERT_EQ(surface.problems.size(), 1u);
  EXPECT_EQ(surface.problems[0].code, "too-few-boundaries");
  EXPECT_EQ(surface.genus, 0);
  // A flat triangle of 5 mm edges lies up to 5^2 / (6 * 30) = 0.14 mm inside a ball of 30 mm: the
  // area is less than one hundredth too small.
  EXPECT_LT(surface.area, 4.0 * pi * 900.0);
  EXPECT_GT(surface.area, 0.99 * 4.0 * pi * 900.0);
  for (Eigen::Index v = 0; v < mesh.vertices.rows(); ++v)
    EXPECT_NEAR(mesh.vertices.row(v).norm(), 30.0, 1e-6);
}

TEST(BlobShape, ACutStickIsATubeWithFlatRims) {
  const BlobMesh mesh = mesh_of_blobs(one_limb(stick), {below, above}, 5.0);
  const Surface surface = surface_of(mesh);
  EXPECT_TRUE(surface.problems.empty());
  ASSERT_EQ(surface.boundaries.size(), 2u);
  EXPECT_NEAR(surface.area, 2.0 * pi * 20.0 * 80.0, 0.01 * 2.0 * pi * 20.0 * 80.0);
  for (const BoundaryLoop& rim : surface.boundaries) {
    // 25 chords of a circle are a quarter of a hundredth short.
    EXPECT_NEAR(rim.length, 2.0 * pi * 20.0, 0.5);
    const double height = surface.mesh.point(TriangleMesh::VertexHandle(rim.vertices[0])).z();
    EXPECT_TRUE(std::abs(height - 10.0) < 1e-9 || std::abs(height - 90.0) < 1e-9);
    for (const int v : rim.vertices)
      EXPECT_NEAR(surface.mesh.point(TriangleMesh::VertexHandle(v)).z(), height, 1e-9);
  }
}

TEST(BlobShape, TrianglesAreEven) {
  // Where limbs meet as well as along them, whatever the lattice did.
  Blobs blobs = one_limb(stick);
  blobs.limbs.push_back({{{0.0, 0.0, 50.0}, 14.0}, {{60.0, 0.0, 90.0}, 12.0}});
  for (const double edge_length : {4.0, 6.0}) {
    const BlobMesh mesh = mesh_of_blobs(blobs, {below, end_of(blobs.limbs[1])}, edge_length);
    double sum = 0.0;
    for (Eigen::Index f = 0; f < mesh.faces.rows(); ++f)
      for (int k = 0; k < 3; ++k) {
        const auto corner = [&](int i) -> Vector3d {
          return mesh.vertices.row(mesh.faces(f, (k + i) % 3)).transpose();
        };
        const Vector3d a = corner(1) - corner(0), b = corner(2) - corner(0);
        EXPECT_GT(std::atan2(a.cross(b).norm(), a.dot(b)), 15.0 * pi / 180.0);
        EXPECT_LT(a.norm(), 1.8 * edge_length);
        sum += a.norm();
      }
    EXPECT_NEAR(sum / (3.0 * mesh.faces.rows()), edge_length, 0.15 * edge_length);
  }
}

TEST(BlobShape, PartsNearEachOtherFlowTogether) {
  const auto pair = [](double apart) {
    Blobs blobs = one_limb({{{-0.5 * apart, 0.0, 0.0}, 20.0}});
    blobs.limbs.push_back({{{0.5 * apart, 0.0, 0.0}, 20.0}});
    return surface_of(mesh_of_blobs(blobs, {}, 5.0)).components;
  };
  EXPECT_EQ(pair(36.0), 1);
  EXPECT_EQ(pair(70.0), 2);
}

TEST(BlobShape, ARingKeepsItsHole) {
  Limb ring;
  for (int i = 0; i <= 24; ++i) {
    const double angle = 2.0 * pi * (i % 24) / 24.0;
    ring.push_back({{40.0 * std::cos(angle), 40.0 * std::sin(angle), 0.0}, 15.0});
  }
  EXPECT_EQ(surface_of(mesh_of_blobs(one_limb(ring), {}, 5.0)).genus, 1);
}

TEST(BlobShape, ACutTakesOneLegAndLeavesTheOther) {
  const BlobMesh mesh =
      mesh_of_blobs(one_limb(arch()), {{{40.0, 0.0, 0.0}, -Vector3d::UnitZ()}}, 5.0);
  double lowest_left = 0.0, lowest_right = 0.0;
  for (Eigen::Index v = 0; v < mesh.vertices.rows(); ++v) {
    double& lowest = mesh.vertices(v, 0) < 0.0 ? lowest_left : lowest_right;
    lowest = std::min(lowest, mesh.vertices(v, 2));
  }
  EXPECT_NEAR(lowest_right, 0.0, 1e-9);
  EXPECT_LT(lowest_left, -25.0);
}

TEST(BlobShape, APlaneThroughVerticesOfTheLatticeLeavesNoSlivers) {
  // Rims at every height: some planes lie in the lattice, others just beside it.
  for (int i = 0; i < 12; ++i) {
    const RimCut lower{{0.0, 0.0, 10.0 + 0.5 * i}, -Vector3d::UnitZ()};
    EXPECT_TRUE(
        surface_of(mesh_of_blobs(one_limb(stick), {lower, above}, 6.0)).problems.empty())
        << "at " << lower.at.z();
  }
}

TEST(BlobShape, TheSameBodyGivesTheSameMesh) {
  const BlobMesh a = mesh_of_blobs(one_limb(stick), {below}, 5.0);
  const BlobMesh b = mesh_of_blobs(one_limb(stick), {below}, 5.0);
  EXPECT_EQ(a.vertices, b.vertices);
  EXPECT_EQ(a.faces, b.faces);
}

TEST(BlobShape, CutsThatMissAndLatticesWithoutEndAreRefused) {
  const RimCut beside{{0.0, 0.0, 200.0}, Vector3d::UnitZ()};
  const RimCut under{{0.0, 0.0, -200.0}, Vector3d::UnitZ()};
  EXPECT_THROW(mesh_of_blobs(one_limb(stick), {beside}, 5.0), InvalidInput);
  EXPECT_THROW(mesh_of_blobs(one_limb(stick), {under}, 5.0), InvalidInput);
  EXPECT_THROW(mesh_of_blobs(one_limb(stick), {}, 0.0), InvalidInput);
  EXPECT_THROW(mesh_of_blobs(one_limb(stick), {}, 0.01), InvalidInput);
}

}  // namespace
}  // namespace meshknit
