#include <gtest/gtest.h>

#include <cmath>

#include "meshknit/knit_graph/knit_graph_checks.h"
#include "meshknit/remesh/finish_graph.h"
#include "meshknit/remesh/relaxation.h"
#include "meshknit/remesh/remesh.h"
#include "meshknit/remesh/section_length.h"
#include "meshknit/remesh/surface_springs.h"
#include "meshknit/remesh/walk.h"
#include "surface/test_meshes.h"

namespace meshknit {
namespace {

constexpr double pi = 3.14159265358979323846;

// A tube of radius 20, 48 corners, 50 mm high, in rings 2.5 mm apart.
TriangleMesh tube_mesh() {
  return half_edges(tube({48, 20, 50.0, [](double) { return 20.0; }}));
}

FacePoint centre_of(const TriangleMesh& mesh, int face) {
  return {face, mesh.calc_face_centroid(TriangleMesh::FaceHandle(face))};
}

// Level and anticlockwise in a triangle's plane.
Eigen::Vector3d across_of(const TriangleMesh& mesh, const FacePoint& at) {
  const Eigen::Vector3d normal = mesh.calc_face_normal(TriangleMesh::FaceHandle(at.face));
  return Eigen::Vector3d::UnitZ().cross(normal).normalized();
}

double side_length() { return 40.0 * std::sin(pi / 48.0); }

TEST(Walk, RoundATubeComesBackToItsStart) {
  const TriangleMesh mesh = tube_mesh();
  const FacePoint start = centre_of(mesh, 400);
  const Eigen::Vector3d ahead = across_of(mesh, start) * (48.0 / 2.0 * side_length());
  const FacePoint half = walk(mesh, start, ahead);
  EXPECT_NEAR(half.position.x(), -start.position.x(), 1e-9);
  EXPECT_NEAR(half.position.y(), -start.position.y(), 1e-9);
  EXPECT_NEAR(half.position.z(), start.position.z(), 1e-9);
}

TEST(Walk, StopsAtTheRim) {
  const TriangleMesh mesh = tube_mesh();
  const FacePoint end = walk(mesh, centre_of(mesh, 400), {0.0, 0.0, 1000.0});
  EXPECT_NEAR(end.position.z(), 50.0, 1e-9);
  EXPECT_EQ(end.face, -1);
}

TEST(Walk, EndsInItsTriangle) {
  const TriangleMesh mesh = tube_mesh();
  for (int face = 200; face < 700; face += 7)
    for (int direction = 0; direction < 12; ++direction) {
      const double a = pi * direction / 6.0;
      const FacePoint start = centre_of(mesh, face);
      const Eigen::Vector3d across = across_of(mesh, start);
      const FacePoint end = walk(
          mesh, start, 9.0 * (std::cos(a) * across + std::sin(a) * Eigen::Vector3d::UnitZ()));
      if (end.face < 0) continue;  // over the rim
      EXPECT_GE(corner_weights(mesh, end).minCoeff(), -1e-9);
    }
}

// Two walls of a three-sided prism, 30 mm wide and 20 mm high, that meet at x = y = 0 at an angle of 60
// degrees.
struct Walls {
  TriangleMesh mesh;
  double s = std::sin(pi / 6.0), c = std::cos(pi / 6.0);

  Walls() {
    std::vector<TriangleMesh::VertexHandle> v;
    for (const double z : {0.0, 20.0})
      for (const Eigen::Vector3d& p :
           {Eigen::Vector3d(30.0 * s, 30.0 * c, z), Eigen::Vector3d(0.0, 0.0, z),
            Eigen::Vector3d(-30.0 * s, 30.0 * c, z)})
        v.push_back(mesh.add_vertex(p));
    for (int wall = 0; wall < 2; ++wall) {
      mesh.add_face(v[wall], v[wall + 1], v[wall + 4]);
      mesh.add_face(v[wall], v[wall + 4], v[wall + 3]);
    }
  }
  FacePoint at(int face, double side, double from_edge, double z) const {
    return {face, Eigen::Vector3d(side * from_edge * s, from_edge * c, z)};
  }
};

TEST(SectionLength, GoesOverASharpEdgeTheShortWay) {
  const Walls walls;
  // 2 mm from the edge on either wall, at one height: 4 mm over the edge. The shortest way begins by
  // going back from the straight line.
  const FacePoint a = walls.at(0, 1.0, 2.0, 1.0), b = walls.at(2, -1.0, 2.0, 1.0);
  EXPECT_NEAR(section_length(walls.mesh, a, b), 4.0, 0.02);
  EXPECT_EQ(section_length(walls.mesh, a, a), 0.0);
}

TEST(SectionLength, LeavesAndArrivesAlongTheSurface) {
  const Walls walls;
  const Section over =
      section(walls.mesh, walls.at(0, 1.0, 2.0, 1.0), walls.at(2, -1.0, 2.0, 1.0));
  // From either point the edge lies straight ahead in its wall.
  EXPECT_LT((over.from_first - Eigen::Vector3d(-walls.s, -walls.c, 0.0)).norm(), 0.1);
  EXPECT_LT((over.from_last - Eigen::Vector3d(walls.s, -walls.c, 0.0)).norm(), 0.1);
}

TEST(SurfaceSprings, PullOverAnEdgeNotThroughTheAir) {
  const Walls walls;
  SurfaceSprings points(walls.mesh);
  points.add(walls.at(0, 1.0, 2.0, 1.0));
  points.add(walls.at(2, -1.0, 2.0, 1.0));
  // The spring wants 10 mm: each end 5 mm from the edge, though only 5 mm from the other.
  points.relax({{0, 1, 10.0}}, {0, 1}, 100);
  EXPECT_NEAR(points.length(0, 1), 10.0, 0.1);
  EXPECT_NEAR((points.point(0).position - points.point(1).position).norm(), 5.0, 0.1);
}

TEST(SurfaceSprings, OnlyWhatIsMovableMoves) {
  const Walls walls;
  SurfaceSprings points(walls.mesh);
  points.add(walls.at(0, 1.0, 4.0, 1.0));
  points.add(walls.at(0, 1.0, 8.0, 1.0));
  points.relax({{0, 1, 6.0}}, {1}, 100);
  EXPECT_EQ(points.point(0).position, walls.at(0, 1.0, 4.0, 1.0).position);
  EXPECT_NEAR(points.length(0, 1), 6.0, 0.1);
}

TEST(SectionLength, GoesRoundTheTubeNotThroughIt) {
  const TriangleMesh mesh = tube_mesh();
  const FacePoint start = centre_of(mesh, 400);
  const Eigen::Vector3d across = across_of(mesh, start);
  for (const double way : {1.0, 3.66, 8.0}) {
    const FacePoint end = walk(mesh, start, way * across);
    EXPECT_NEAR(section_length(mesh, start, end), way, 0.001 * way);
    const FacePoint up = walk(mesh, start, way * Eigen::Vector3d::UnitZ());
    EXPECT_NEAR(section_length(mesh, start, up), way, 1e-9);
    // On a tube, which can be flattened, a straight way stays the shortest at any slant.
    const FacePoint slanted =
        walk(mesh, start, way * (0.6 * across + 0.8 * Eigen::Vector3d::UnitZ()));
    EXPECT_NEAR(section_length(mesh, start, slanted), way, 0.01 * way);
    EXPECT_NEAR(section_length(mesh, slanted, start), way, 0.01 * way);
  }
}

// Five rows of 12 nodes on a tube, drawn with uneven places.
struct UnevenRows {
  TriangleMesh mesh = tube_mesh();
  std::vector<double> time;
  std::vector<int> faces;
  KnitGraph graph;
};
UnevenRows uneven_rows() {
  UnevenRows drawn;
  for (const auto v : drawn.mesh.vertices())
    drawn.time.push_back(drawn.mesh.point(v).z() / 25.0 - 1.0);
  drawn.graph.stitch_width = 48.0 * side_length() / 12.0;
  drawn.graph.stitch_height = 5.0;
  Jitter jitter(2);
  // Walking from one place to all others keeps nodes on the surface.
  const FacePoint origin = walk(drawn.mesh, centre_of(drawn.mesh, 0), {0.0, 0.0, 2.0});
  const Eigen::Vector3d across = across_of(drawn.mesh, origin);
  for (int r = 0; r < 5; ++r) {
    KnitRow row;
    for (int i = 0; i < 12; ++i) {
      const bool inner = r > 0 && r < 4;
      const double aside = i + (inner ? 0.3 * jitter.next() : 0.0);
      const double up = r + (inner ? 0.3 * jitter.next() : 0.0);
      const FacePoint at = walk(
          drawn.mesh, origin,
          aside * drawn.graph.stitch_width * across + 10.0 * up * Eigen::Vector3d::UnitZ());
      row.nodes.push_back(static_cast<int>(drawn.graph.nodes.size()));
      drawn.graph.nodes.push_back({at.position, 0.0});
      drawn.faces.push_back(at.face);
      if (r > 0) drawn.graph.columns.push_back({12 * (r - 1) + i, 12 * r + i});
    }
    drawn.graph.rows.push_back(row);
  }
  return drawn;
}

double summed_squared_error(UnevenRows drawn) {
  finish_graph(drawn.mesh, drawn.faces, drawn.graph);
  double sum = 0.0;
  for (const auto& lengths : drawn.graph.row_lengths)
    for (const double length : lengths) sum += std::pow(length - drawn.graph.stitch_width, 2);
  for (const double length : drawn.graph.column_lengths) sum += std::pow(length - 10.0, 2);
  return sum;
}

TEST(Relaxation, BringsStitchesNearerToTheirSizesWithoutLeavingTheSurface) {
  UnevenRows drawn = uneven_rows();
  const KnitGraph before = drawn.graph;
  const double error = summed_squared_error(drawn);
  relax_nodes(drawn.mesh, drawn.time, drawn.faces, drawn.graph);
  EXPECT_LT(summed_squared_error(drawn), 0.2 * error);
  EXPECT_EQ(drawn.graph.columns, before.columns);
  for (int r = 0; r < 5; ++r) EXPECT_EQ(drawn.graph.rows[r].nodes, before.rows[r].nodes);
  for (std::size_t i = 0; i < drawn.graph.nodes.size(); ++i) {
    const KnitNode& node = drawn.graph.nodes[i];
    const FacePoint at{drawn.faces[i], node.position};
    EXPECT_GE(corner_weights(drawn.mesh, at).minCoeff(), -1e-9);
    EXPECT_NEAR(node.time, node.position.z() / 25.0 - 1.0, 1e-9);
    if (i < 12 || i >= 48) {
      EXPECT_EQ(node.position, before.nodes[i].position);
    }
  }
}

TEST(Relaxation, TellsItsProgress) {
  UnevenRows drawn = uneven_rows();
  std::vector<double> told;
  relax_nodes(drawn.mesh, drawn.time, drawn.faces, drawn.graph,
              [&](double fraction) { told.push_back(fraction); });
  ASSERT_FALSE(told.empty());
  for (std::size_t k = 1; k < told.size(); ++k) EXPECT_GT(told[k], told[k - 1]);
  EXPECT_LE(told.back(), 1.0);
}

TEST(FinishGraph, MeasuresEveryEdgeAndPutsColumnsInOrder) {
  UnevenRows drawn = uneven_rows();
  std::swap(drawn.graph.columns[0], drawn.graph.columns[30]);
  finish_graph(drawn.mesh, drawn.faces, drawn.graph);
  EXPECT_TRUE(check_graph_form(drawn.graph).empty());
  for (std::size_t k = 1; k < drawn.graph.columns.size(); ++k)
    EXPECT_LE(drawn.graph.columns[k - 1][0], drawn.graph.columns[k][0]);
  // The first row was drawn evenly, straight round the tube.
  for (const double length : drawn.graph.row_lengths[0])
    EXPECT_NEAR(length, drawn.graph.stitch_width, 0.001);
}

}  // namespace
}  // namespace meshknit
