#include "meshknit/surface/refine.h"

#include <gtest/gtest.h>

#include <cmath>

#include "meshknit/core/error.h"
#include "surface/test_meshes.h"

namespace meshknit {
namespace {

std::vector<double> heights(const TriangleMesh& mesh) {
  std::vector<double> value;
  for (const auto v : mesh.vertices()) value.push_back(mesh.point(v).z());
  return value;
}

double area(const TriangleMesh& mesh) {
  double sum = 0.0;
  for (const auto f : mesh.faces()) sum += mesh.calc_face_area(f);
  return sum;
}

int faces_on_the_boundary(const TriangleMesh& mesh) {
  int count = 0;
  for (const auto f : mesh.faces()) {
    int on = 0;
    for (const auto v : mesh.fv_range(f)) on += mesh.is_boundary(v) ? 1 : 0;
    count += on == 3 ? 1 : 0;
  }
  return count;
}

TEST(RefineMesh, NoEdgeIsLongerThanAskedAndTheClothKeepsItsArea) {
  const TriangleMesh coarse = half_edges(tube({8, 3}));
  const RefinedMesh fine = refine_mesh(coarse, heights(coarse), 2.0);
  for (const auto e : fine.mesh.edges()) EXPECT_LE(fine.mesh.calc_edge_length(e), 2.0);
  EXPECT_NEAR(area(fine.mesh), area(coarse), 1e-6 * area(coarse));
  // A tube has Euler characteristic 0, however fine.
  EXPECT_EQ(fine.mesh.n_vertices() + fine.mesh.n_faces(), fine.mesh.n_edges());
}

TEST(RefineMesh, ValuesAreLinearOnTheOldFaces) {
  const TriangleMesh coarse = half_edges(tube({8, 3}));
  const RefinedMesh fine = refine_mesh(coarse, heights(coarse), 3.0);
  // Height is a linear function of the place, so every new vertex must have its own height.
  for (const auto v : fine.mesh.vertices())
    EXPECT_NEAR(fine.value[v.idx()], fine.mesh.point(v).z(), 1e-9);
}

TEST(RefineMesh, EveryNewFaceLiesInItsSourceFace) {
  const TriangleMesh coarse = half_edges(tube({8, 3}));
  const RefinedMesh fine = refine_mesh(coarse, heights(coarse), 3.0);
  ASSERT_EQ(fine.source_face.size(), fine.mesh.n_faces());
  std::vector<double> covered(coarse.n_faces(), 0.0);
  for (const auto f : fine.mesh.faces()) {
    const OpenMesh::FaceHandle source(fine.source_face[f.idx()]);
    covered[source.idx()] += fine.mesh.calc_face_area(f);
    const Eigen::Vector3d off =
        fine.mesh.calc_face_centroid(f) - coarse.calc_face_centroid(source);
    EXPECT_NEAR(off.dot(coarse.calc_face_normal(source)), 0.0, 1e-9);
  }
  for (const auto f : coarse.faces())
    EXPECT_NEAR(covered[f.idx()], coarse.calc_face_area(f), 1e-6 * coarse.calc_face_area(f));
}

TEST(RefineMesh, KeepsTheOldVerticesFirst) {
  const TriangleMesh coarse = half_edges(tube({8, 3}));
  const RefinedMesh fine = refine_mesh(coarse, heights(coarse), 3.0);
  for (const auto v : coarse.vertices())
    EXPECT_EQ(fine.mesh.point(OpenMesh::VertexHandle(v.idx())), coarse.point(v));
}

TEST(RefineMesh, EdgesAcrossTheClothBetweenBoundaryVerticesAreSplit) {
  // One square of two triangles: its diagonal joins two boundary vertices, and at 3 mm the
  // boundary is split too, which makes more such edges on the way.
  for (const double max_edge : {100.0, 3.0}) {
    const TriangleMesh square = half_edges(grid(1, 1, 10.0, [](int, int) { return false; }));
    ASSERT_EQ(faces_on_the_boundary(square), 2);
    const RefinedMesh fine = refine_mesh(square, heights(square), max_edge);
    EXPECT_EQ(faces_on_the_boundary(fine.mesh), 0);
  }
}

TEST(RefineMesh, ALoneTriangleMayStay) {
  MeshArrays one = grid(1, 1, 10.0, [](int, int) { return false; });
  one.faces.conservativeResize(1, 3);
  const TriangleMesh triangle = half_edges(one);
  EXPECT_EQ(refine_mesh(triangle, heights(triangle), 100.0).mesh.n_faces(), 1u);
}

TEST(RefineMesh, RefusesUsageThatMakesNoSense) {
  const TriangleMesh mesh = half_edges(tube());
  EXPECT_THROW(refine_mesh(mesh, {0.0}, 1.0), InvalidInput);
  EXPECT_THROW(refine_mesh(mesh, heights(mesh), 0.0), InvalidInput);
  EXPECT_THROW(refine_mesh(mesh, heights(mesh), std::nan("")), InvalidInput);
}

}  // namespace
}  // namespace meshknit
