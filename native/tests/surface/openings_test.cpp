#include "meshknit/surface/openings.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <limits>

#include "meshknit/core/error.h"
#include "surface/exact_point_distances.h"
#include "surface/test_meshes.h"

namespace meshknit {
namespace {

constexpr double pi = 3.14159265358979323846;

CutSurface cut(const MeshArrays& arrays, const std::vector<OpeningMark>& marks) {
  CutSurface result = cut_openings(arrays.vertices, arrays.faces, {}, marks);
  for (const Problem& p : check_cut(arrays.vertices, arrays.faces, marks, result))
    ADD_FAILURE() << p.code << ": " << p.message;
  return result;
}

std::string error_of(const MeshArrays& arrays, const std::vector<OpeningMark>& marks) {
  const CutSurface result = cut(arrays, marks);
  EXPECT_TRUE(result.openings.empty());
  EXPECT_EQ(result.faces, arrays.faces);  // nothing was cut
  for (const Problem& p : result.problems) {
    if (p.severity != Severity::error) continue;
    EXPECT_FALSE(p.message.empty() || p.remedy.empty());
    return p.code;
  }
  return "";
}

// Exact distances of the rim's vertices from the place, over the radius.
std::vector<double> rim_ratios(const MeshArrays& arrays, const CutSurface& result,
                               const OpeningMark& mark, const Opening& opening) {
  std::vector<SurfacePoint> places;
  for (const int v : opening.rim)
    for (Eigen::Index f = 0; f < result.faces.rows(); ++f)
      if ((result.faces.row(f).array() == v).any()) {
        places.push_back({result.source_face[static_cast<std::size_t>(f)],
                          Eigen::Vector3d(result.vertices.row(v))});
        break;
      }
  const SurfacePoint source = nearest_face(half_edges(arrays), mark.at);
  std::vector<double> ratios = exact_distances_from(arrays, source, places);
  for (double& r : ratios) r /= mark.radius;
  return ratios;
}

void expect_round(const MeshArrays& arrays, const CutSurface& result,
                  const std::vector<OpeningMark>& marks) {
  ASSERT_EQ(result.openings.size(), marks.size());
  for (const Opening& opening : result.openings) {
    EXPECT_GE(opening.rim.size(), 16u);
    for (const double r : rim_ratios(arrays, result, marks[opening.mark], opening))
      EXPECT_NEAR(r, 1.0, 0.02);
  }
}

// The least angle of a triangle with a corner on a rim.
double least_angle_at(const CutSurface& result, const Opening& opening) {
  double least = 4.0;
  for (Eigen::Index f = 0; f < result.faces.rows(); ++f)
    for (int k = 0; k < 3; ++k) {
      if (std::count(opening.rim.begin(), opening.rim.end(), result.faces(f, k)) == 0) continue;
      for (int c = 0; c < 3; ++c) {
        const Eigen::Vector3d at = result.vertices.row(result.faces(f, c));
        const Eigen::Vector3d a =
            Eigen::Vector3d(result.vertices.row(result.faces(f, (c + 1) % 3))) - at;
        const Eigen::Vector3d b =
            Eigen::Vector3d(result.vertices.row(result.faces(f, (c + 2) % 3))) - at;
        least = std::min(least, std::atan2(a.cross(b).norm(), a.dot(b)));
      }
    }
  return least;
}

TEST(CutOpenings, ARimOnABallIsACircleOfLatitude) {
  // A geodesic circle of radius r on a ball of radius R is 2 pi R sin(r / R) round.
  const MeshArrays arrays = ball(50.0, 5);
  for (const double radius : {8.0, 25.0, 60.0}) {
    SCOPED_TRACE(radius);
    const std::vector<OpeningMark> marks{{{0.0, 0.0, 50.0}, radius}};
    const CutSurface result = cut(arrays, marks);
    EXPECT_TRUE(result.problems.empty());
    expect_round(arrays, result, marks);
    EXPECT_NEAR(result.openings[0].rim_length, 2.0 * pi * 50.0 * std::sin(radius / 50.0),
                0.01 * result.openings[0].rim_length);
  }
}

TEST(CutOpenings, TwoOpeningsMakeABallATube) {
  const MeshArrays arrays = ball(50.0);
  const CutSurface result = cut(arrays, {{{0.0, 0.0, 50.0}, 15.0}, {{3.0, -1.0, -49.0}, 12.0}});
  ASSERT_EQ(result.openings.size(), 2u);
  EXPECT_EQ(result.openings[0].mark, 0);
  EXPECT_EQ(result.openings[1].mark, 1);
  for (const int v : result.openings[0].rim) EXPECT_GT(result.vertices(v, 2), 40.0);
  for (const int v : result.openings[1].rim) EXPECT_LT(result.vertices(v, 2), -40.0);
  const Surface surface = make_surface(result.vertices, result.faces);
  EXPECT_TRUE(surface.problems.empty());
  EXPECT_EQ(surface.boundaries.size(), 2u);
  EXPECT_EQ(surface.genus, 0);
}

TEST(CutOpenings, ACoarseBoxGetsARoundHoleInASide) {
  const MeshArrays arrays = box({100.0, 100.0, 100.0});
  const std::vector<OpeningMark> marks{{{40.0, 55.0, 100.0}, 10.0}};
  const CutSurface result = cut(arrays, marks);
  expect_round(arrays, result, marks);
  const Opening& opening = result.openings[0];
  for (const int v : opening.rim) EXPECT_DOUBLE_EQ(result.vertices(v, 2), 100.0);
  EXPECT_NEAR(opening.rim_length, 2.0 * pi * 10.0, 0.01 * 2.0 * pi * 10.0);
  // The area of a disc is gone.
  const Surface left = make_surface(result.vertices, result.faces);
  EXPECT_NEAR(60000.0 - left.area, pi * 100.0, 0.02 * pi * 100.0);
}

TEST(CutOpenings, ACornerOfABoxLeavesThreeQuartersOfACircle) {
  // Round a corner of three right angles there are 270 degrees, over an edge there are 360.
  const MeshArrays arrays = box({100.0, 100.0, 100.0});
  const std::vector<OpeningMark> corner{{{100.0, 100.0, 100.0}, 20.0}};
  const std::vector<OpeningMark> edge{{{40.0, 100.0, 100.0}, 20.0}};
  const CutSurface at_corner = cut(arrays, corner), at_edge = cut(arrays, edge);
  expect_round(arrays, at_corner, corner);
  expect_round(arrays, at_edge, edge);
  EXPECT_NEAR(at_corner.openings[0].rim_length, 1.5 * pi * 20.0, 0.01 * 1.5 * pi * 20.0);
  EXPECT_NEAR(at_edge.openings[0].rim_length, 2.0 * pi * 20.0, 0.01 * 2.0 * pi * 20.0);
}

TEST(CutOpenings, ACornerBesideThePlaceIsCutToo) {
  const MeshArrays arrays = box({100.0, 100.0, 100.0});
  const std::vector<OpeningMark> marks{{{95.0, 92.0, 100.0}, 25.0}};
  const CutSurface result = cut(arrays, marks);
  expect_round(arrays, result, marks);
}

TEST(CutOpenings, LeavesNoSlivers) {
  // Rivara leaves half of the least angle; snapping 0.15 of an edge keeps a sixth of that.
  const MeshArrays arrays = ball(50.0, 3);
  Jitter jitter(5);
  for (int i = 0; i < 40; ++i) {
    const Eigen::Vector3d at =
        50.0 * Eigen::Vector3d(jitter.next(), jitter.next(), jitter.next()).normalized();
    const std::vector<OpeningMark> marks{{at, 10.0 + 4.0 * jitter.next()}};
    const CutSurface result = cut(arrays, marks);
    ASSERT_EQ(result.openings.size(), 1u);
    expect_round(arrays, result, marks);
    EXPECT_GT(least_angle_at(result, result.openings[0]), pi / 180.0 * 4.0) << i;
  }
}

TEST(CutOpenings, RimsAreRoundOnAnUnevenMesh) {
  TubeShape shape;
  shape.jitter = 0.35;
  shape.around = 20;
  shape.along = 14;
  shape.radius = [](double z) { return 30.0 + 6.0 * std::sin(0.1 * z); };
  const MeshArrays arrays = tube(shape);
  for (const double radius : {5.0, 12.0, 24.0}) {
    const std::vector<OpeningMark> marks{{{30.0, 0.0, 52.0}, radius}};
    const CutSurface result = cut(arrays, marks);
    expect_round(arrays, result, marks);
  }
}

TEST(CutOpenings, KeepsTheUsersVertices) {
  const MeshArrays arrays = ball(50.0);
  const CutSurface result = cut(arrays, {{{0.0, 0.0, 50.0}, 15.0}});
  int left_out = 0;
  for (std::size_t row = 0; row < result.vertex_of_source.size(); ++row) {
    const int v = result.vertex_of_source[row];
    if (v < 0) {
      ++left_out;
      EXPECT_GT(arrays.vertices(static_cast<Eigen::Index>(row), 2), 47.0);
    } else {
      EXPECT_EQ(result.source_vertex[v], static_cast<int>(row));
    }
  }
  EXPECT_GT(left_out, 0);
}

TEST(CutOpenings, TriangleSoupIsCutAsOneSurface) {
  const CutSurface result = cut(triangle_soup(ball(50.0, 3)), {{{0.0, 0.0, 50.0}, 15.0}});
  ASSERT_EQ(result.openings.size(), 1u);
  EXPECT_NE(find_problem(result.problems, "doubled-vertices"), nullptr);
}

TEST(CutOpenings, GivesTheSameBytesTwice) {
  const std::vector<OpeningMark> marks{{{0.0, 0.0, 50.0}, 15.0}, {{0.0, 50.0, 0.0}, 9.0}};
  const CutSurface one = cut(ball(50.0), marks), other = cut(ball(50.0), marks);
  EXPECT_EQ(one.vertices, other.vertices);
  EXPECT_EQ(one.faces, other.faces);
}

TEST(CutOpenings, AnOpeningForFourStitchesSaysHowLargeItMustBe) {
  // Six stitches of 3.66 mm are 21.96 mm: a circle of radius 3.495 mm in the flat.
  const MeshArrays arrays = box({100.0, 100.0, 100.0});
  EXPECT_EQ(error_of(arrays, {{{50.0, 50.0, 100.0}, 2.4}}), "opening-too-small");
  EXPECT_EQ(error_of(arrays, {{{50.0, 50.0, 100.0}, 1e-9}}), "opening-too-small");
  const CutSurface refused = cut(arrays, {{{50.0, 50.0, 100.0}, 2.4}});
  EXPECT_NE(refused.problems[0].remedy.find("at least 3.6 mm"), std::string::npos)
      << refused.problems[0].remedy;
  EXPECT_TRUE(cut(arrays, {{{50.0, 50.0, 100.0}, 3.6}}).problems.empty());
}

TEST(CutOpenings, ARadiusMustBeALength) {
  const MeshArrays arrays = ball(50.0, 2);
  const double nan = std::numeric_limits<double>::quiet_NaN();
  for (const double radius : {0.0, -5.0, nan, std::numeric_limits<double>::infinity()})
    EXPECT_EQ(error_of(arrays, {{{0.0, 0.0, 50.0}, radius}}), "opening-radius");
  EXPECT_EQ(error_of(arrays, {{{0.0, nan, 50.0}, 10.0}}), "opening-radius");
}

TEST(CutOpenings, APlaceMustLieOnTheSurface) {
  EXPECT_EQ(error_of(ball(50.0), {{{0.0, 0.0, 80.0}, 10.0}}), "opening-off-surface");
  EXPECT_EQ(error_of(ball(50.0), {{{0.0, 0.0, 0.05}, 10.0}}), "opening-off-surface");  // metres
  EXPECT_TRUE(cut(ball(50.0), {{{0.0, 0.0, 55.0}, 10.0}}).problems.empty());
}

TEST(CutOpenings, AnOpeningMustLeaveSomethingToKnit) {
  // The far pole of a ball is 50 pi = 157 mm away; at 155 mm a rim of about 14 mm is left.
  EXPECT_EQ(error_of(ball(50.0), {{{0.0, 0.0, 50.0}, 170.0}}), "opening-swallows-part");
  EXPECT_EQ(error_of(ball(50.0), {{{0.0, 0.0, 50.0}, 1e9}}), "opening-swallows-part");
  EXPECT_EQ(error_of(ball(50.0, 5), {{{0.0, 0.0, 50.0}, 154.0}}), "opening-too-large");
}

TEST(CutOpenings, AnOpeningRoundALimbIsNone) {
  // Half way round a tube of radius 10 is 31 mm: a disc of 40 mm meets itself at the back.
  TubeShape limb;
  limb.length = 200.0;
  limb.radius = [](double) { return 10.0; };
  EXPECT_EQ(error_of(tube(limb), {{{10.0, 0.0, 100.0}, 40.0}}), "opening-not-a-disc");
  const CutSurface refused = cut(tube(limb), {{{10.0, 0.0, 100.0}, 40.0}});
  EXPECT_NE(refused.problems[0].message.find("2 rims"), std::string::npos);
}

TEST(CutOpenings, AnOpeningMustStayAwayFromBoundaries) {
  EXPECT_EQ(error_of(tube(), {{{20.0, 0.0, 8.0}, 10.0}}), "opening-over-boundary");
  // Swallows a small window of the mesh.
  const MeshArrays window =
      grid(40, 40, 5.0, [](int x, int y) { return x == 20 && (y == 20 || y == 21); });
  EXPECT_EQ(error_of(window, {{{90.0, 90.0, 0.0}, 40.0}}), "opening-over-boundary");
}

TEST(CutOpenings, OpeningsMustNotOverlapOrTouch) {
  const MeshArrays arrays = ball(50.0);
  const OpeningMark top{{0.0, 0.0, 50.0}, 15.0};
  EXPECT_EQ(error_of(arrays, {top, {{20.0, 0.0, 45.0}, 15.0}}), "openings-overlap");
  EXPECT_EQ(error_of(arrays, {top, top}), "openings-overlap");
  EXPECT_EQ(error_of(arrays, {{{0.0, 0.0, 50.0}, 5.0}, top}), "openings-overlap");
  // 60 degrees apart on the ball are 52.4 mm.
  const Eigen::Vector3d aside(50.0 * std::sin(pi / 3), 0.0, 25.0);
  EXPECT_TRUE(cut(arrays, {{{0.0, 0.0, 50.0}, 25.0}, {aside, 25.0}}).problems.empty());
}

TEST(CutOpenings, RandomOpeningsLeaveASurfaceOrSayWhyNot) {
  const std::vector<MeshArrays> shapes{ball(50.0, 3), box({120.0, 80.0, 4.0}), closed_torus()};
  Jitter jitter(11);
  int cut_well = 0;
  for (int i = 0; i < 150; ++i) {
    SCOPED_TRACE(i);
    const MeshArrays& arrays = shapes[static_cast<std::size_t>(i % 3)];
    std::vector<OpeningMark> marks;
    for (int k = 0; k < 1 + i % 4; ++k) {
      const auto face = static_cast<Eigen::Index>((0.5 + 0.5 * jitter.next()) *
                                                  static_cast<double>(arrays.faces.rows()));
      // A vertex, a place on an edge, or one inside of a face: those are where cuts go wrong.
      const double b = k % 2 ? 0.0 : 0.3 * (1.0 + jitter.next()), c = k % 3 ? 0.0 : 0.2;
      const Eigen::Vector3d at = (1.0 - b - c) * arrays.vertices.row(arrays.faces(face, 0)) +
                                 b * arrays.vertices.row(arrays.faces(face, 1)) +
                                 c * arrays.vertices.row(arrays.faces(face, 2));
      marks.push_back({at, std::pow(10.0, 1.2 + 0.5 * jitter.next())});
    }
    const CutSurface result = cut(arrays, marks);
    if (has_errors(result.problems)) continue;
    ++cut_well;
    const Surface left = make_surface(result.vertices, result.faces);
    EXPECT_EQ(left.boundaries.size(), marks.size());
    EXPECT_EQ(left.components, 1);
    EXPECT_EQ(left.genus, i % 3 == 2 ? 1 : 0);
  }
  EXPECT_GT(cut_well, 50);
}

TEST(CutOpenings, BrokenMeshesAreRefusedAsByMakeSurface) {
  MeshArrays arrays = ball(50.0, 2);
  arrays.vertices(3, 1) = std::numeric_limits<double>::quiet_NaN();
  EXPECT_EQ(error_of(arrays, {{{0.0, 0.0, 50.0}, 15.0}}), "not-finite");
  EXPECT_THROW(cut_openings(arrays.vertices, arrays.faces, {1, 2}, {}), InvalidInput);
}

TEST(CheckCut, FindsWhatIsBroken) {
  const MeshArrays arrays = ball(50.0);
  const std::vector<OpeningMark> marks{{{0.0, 0.0, 50.0}, 15.0}};
  const CutSurface good = cut(arrays, marks);
  const auto code = [&](const CutSurface& broken) {
    const Problems problems = check_cut(arrays.vertices, arrays.faces, marks, broken);
    return problems.empty() ? std::string() : problems[0].code;
  };
  CutSurface moved = good;
  moved.vertices(2, 0) += 1e-6;
  EXPECT_EQ(code(moved), "cut-moved-vertex");
  CutSurface lifted = good;
  lifted.vertices.row(good.openings[0].rim[3]) *= 1.1;
  EXPECT_EQ(code(lifted), "cut-off-surface");
  CutSurface elsewhere = good;
  elsewhere.openings[0].rim[0] = 0;
  EXPECT_EQ(code(elsewhere), "cut-rim-not-boundary");
  const std::vector<OpeningMark> smaller{{{0.0, 0.0, 50.0}, 14.0}};
  EXPECT_NE(
      find_problem(check_cut(arrays.vertices, arrays.faces, smaller, good), "cut-rim-distance"),
      nullptr);
  CutSurface forgotten = good;
  forgotten.openings.clear();
  EXPECT_EQ(code(forgotten), "cut-characteristic");
}

}  // namespace
}  // namespace meshknit
