#include "meshknit/time_field/time_field.h"

#include <gtest/gtest.h>

#include <cmath>

#include "meshknit/core/error.h"
#include "meshknit/time_field/field_weights.h"
#include "surface/test_meshes.h"

namespace meshknit {
namespace {

Surface surface_of(const MeshArrays& arrays) {
  return make_surface(arrays.vertices, arrays.faces, {0.5, 6});
}

// One time a boundary, in the order of the surface's boundaries.
std::vector<TimeConstraint> boundary_times(const Surface& surface,
                                           const std::vector<double>& times) {
  std::vector<TimeConstraint> constraints;
  for (std::size_t b = 0; b < times.size(); ++b)
    constraints.push_back({surface.boundaries[b].vertices, times[b]});
  return constraints;
}

TimeField field_of(const Surface& surface, const std::vector<double>& times) {
  return solve_time_field(surface, boundary_times(surface, times));
}

double height(const Surface& surface, std::size_t v) {
  return surface.mesh.point(OpenMesh::VertexHandle(static_cast<int>(v))).z();
}

// Inner vertices of an upright tube slide up and down; it stays the same prism.
MeshArrays tube_with_uneven_rings() {
  MeshArrays arrays = tube({24, 12});
  Jitter jitter(3);
  for (Eigen::Index v = 24; v < 12 * 24; ++v) arrays.vertices(v, 2) += 3.5 * jitter.next();
  return arrays;
}

TEST(TimeField, RisesEvenlyAlongAPrismHoweverItIsCutIntoTriangles) {
  const Surface surface = surface_of(tube_with_uneven_rings());
  const TimeField field = field_of(surface, {-1.0, 1.0});
  for (std::size_t v = 0; v < field.time.size(); ++v)
    EXPECT_NEAR(field.time[v], 2.0 * height(surface, v) / 100.0 - 1.0, 1e-6);
  EXPECT_EQ(field.check.extrema, 0);
  EXPECT_EQ(field.check.saddles, 0);
}

TEST(TimeField, KeptWeightsServeEveryChainAlike) {
  const Surface surface = surface_of(tube_with_uneven_rings());
  const FieldWeights weights = field_weights(surface);
  const std::vector<int> rim = surface.boundaries[0].vertices,
                         other = surface.boundaries[1].vertices;
  const std::vector<int> chain = {6 * 24, 6 * 24 + 1, 6 * 24 + 2};
  for (const auto& chains : {std::vector<std::vector<int>>{rim, other},
                             std::vector<std::vector<int>>{rim, other, chain}}) {
    std::vector<double> times = {-1.0, 1.0, 0.7};
    times.resize(chains.size());
    EXPECT_EQ(TimeFieldSolver(weights, chains).solve(times),
              TimeFieldSolver(surface, chains).solve(times));
  }
}

TEST(TimeField, OnAConeFollowsTheLogarithmOfTheDistanceFromTheTip) {
  // The harmonic function of one radius on a cone is a + b log r: rows get closer where it
  // narrows.
  TubeShape cone;
  cone.around = 48;
  cone.along = 40;
  cone.radius = [](double z) { return 60.0 - 0.5 * z; };
  const Surface surface = surface_of(tube(cone));
  const TimeField field = field_of(surface, {-1.0, 1.0});
  for (std::size_t v = 0; v < field.time.size(); ++v) {
    const double r = cone.radius(height(surface, v));
    const double expected = -1.0 + 2.0 * std::log(60.0 / r) / std::log(60.0 / 10.0);
    EXPECT_NEAR(field.time[v], expected, 0.01);
  }
}

TEST(TimeField, SaddlesAreAsManyAsTheShapeNeeds) {
  struct Case {
    Surface surface;
    std::vector<double> times;
    int saddles;  // 2g - 2 + b
  };
  const auto two_holes = [](int c, int r) { return r >= 4 && r < 7 && (c == 3 || c == 9); };
  TubeShape bumpy;
  bumpy.radius = [](double z) {
    return 20.0 + 15.0 * std::exp(-0.01 * (z - 40.0) * (z - 40.0));
  };
  bumpy.jitter = 0.45;
  const std::vector<Case> cases = {
      {surface_of(tube(bumpy)), {-1.0, 1.0}, 0},
      {surface_of(grid(13, 11, 5.0, two_holes)), {-1.0, 1.0, 1.0}, 1},  // trousers laid flat
      {surface_of(without_quads(closed_torus(), {0, 1, 140, 141})), {-1.0, 1.0}, 2},
  };
  for (const Case& c : cases) {
    const TimeField field = field_of(c.surface, c.times);
    EXPECT_TRUE(field.check.problems.empty());
    EXPECT_EQ(field.check.extrema, 0);
    EXPECT_EQ(field.check.saddles, c.saddles);
    EXPECT_EQ(field.check.expected_saddles, c.saddles);
  }
}

TEST(TimeField, HasNoFalseExtremaOnSlivers) {
  TubeShape shape;
  shape.around = 40;
  shape.along = 6;
  shape.length = 2400.0;
  shape.radius = [](double z) { return 50.0 + 20.0 * std::sin(z / 300.0); };
  shape.jitter = 0.45;
  EXPECT_EQ(field_of(surface_of(tube(shape)), {-1.0, 1.0}).check.extrema, 0);
}

TEST(TimeField, FallsBackToTheMeshsOwnNeighboursWhereTheShapeTrueFieldFails) {
  // Six-sided and deeply waved: many of the flips join vertices that are no neighbours on the
  // mesh, and an average of those may stick out among the mesh's neighbours.
  TubeShape shape;
  shape.around = 6;
  shape.along = 12;
  shape.length = 20.0;
  shape.radius = [](double z) { return 50.0 + 30.0 * std::sin(0.45 * z); };
  shape.jitter = 0.3;
  const Surface surface = surface_of(tube(shape));
  const TimeFieldSolver shape_true(
      surface, {surface.boundaries[0].vertices, surface.boundaries[1].vertices});
  ASSERT_GT(check_time_field(surface, shape_true.solve({-1.0, 1.0})).extrema, 0);
  const TimeField field = field_of(surface, {-1.0, 1.0});
  EXPECT_EQ(field.check.extrema, 0);
  EXPECT_EQ(field.check.saddles, 0);
}

// A flat ring with a closed square finger, 40 times as long as wide, standing on it.
MeshArrays ring_with_finger() {
  MeshArrays arrays = grid(9, 9, 5.0, [](int c, int r) {
    return (c >= 3 && c < 6 && r >= 3 && r < 6) || (c == 1 && r == 4);
  });
  std::vector<int> rim = {4 * 10 + 1, 4 * 10 + 2, 5 * 10 + 2, 5 * 10 + 1};  // anticlockwise
  const auto face = [&](int a, int b, int c) {
    arrays.faces.conservativeResize(arrays.faces.rows() + 1, 3);
    arrays.faces.row(arrays.faces.rows() - 1) << a, b, c;
  };
  for (int level = 1; level <= 40; ++level) {
    std::vector<int> next;
    for (const int v : rim) {
      next.push_back(static_cast<int>(arrays.vertices.rows()));
      arrays.vertices.conservativeResize(arrays.vertices.rows() + 1, 3);
      arrays.vertices.row(next.back()) = arrays.vertices.row(v);
      arrays.vertices(next.back(), 2) = 5.0 * level;
    }
    for (int i = 0; i < 4; ++i) {
      const int j = (i + 1) % 4;
      face(rim[i], rim[j], next[j]);
      face(rim[i], next[j], next[i]);
    }
    rim = next;
  }
  face(rim[0], rim[1], rim[2]);
  face(rim[0], rim[2], rim[3]);
  return arrays;
}

TEST(TimeField, ALongFingerWhereTimeStandsStillIsNoExtremum) {
  // Along a finger of perimeter 20 mm differences shrink e-fold every 20 / (2 pi) = 3.2 mm:
  // after 200 mm they are far below what numbers can hold, and only rounding is left.
  const Surface surface = surface_of(ring_with_finger());
  const TimeField field = field_of(surface, {-1.0, 1.0});
  EXPECT_EQ(field.check.extrema, 0);
  EXPECT_EQ(field.check.saddles, field.check.expected_saddles);
  EXPECT_NE(find_problem(field.check.problems, "time-stands-still"), nullptr);
}

TEST(TimeField, SurvivesBeingStoredInSinglePrecision) {
  for (const MeshArrays& arrays : {ring_with_finger(), tube_with_uneven_rings()}) {
    const Surface surface = surface_of(arrays);
    std::vector<double> time = field_of(surface, {-1.0, 1.0}).time;
    for (double& t : time) t = static_cast<float>(t);
    EXPECT_FALSE(has_errors(check_time_field(surface, time).problems));
  }
}

std::vector<int> ring(int level) {
  std::vector<int> vertices;
  for (int i = 0; i < 24; ++i) vertices.push_back(24 * level + i);
  return vertices;
}

TEST(TimeField, AChainInsideIsKnitAtItsTime) {
  const Surface surface = surface_of(tube({24, 12}));
  std::vector<TimeConstraint> constraints = boundary_times(surface, {-1.0, 1.0});
  constraints.push_back({ring(3), 0.5});  // a quarter up, where an even rise has -0.5
  const TimeField field = solve_time_field(surface, constraints);
  for (const int v : ring(3)) EXPECT_EQ(field.time[v], 0.5);
  EXPECT_EQ(field.check.extrema, 0);
  EXPECT_EQ(field.check.saddles, 0);

  constraints.push_back({{24 * 3 + 5, 24 * 3 + 6}, 0.5});
  EXPECT_EQ(solve_time_field(surface, constraints).time, field.time)
      << "the same time twice is no contradiction";
}

TEST(TimeField, AChainThatMakesARidgeIsRefusedNamingIt) {
  const Surface surface = surface_of(tube({24, 12}));
  std::vector<TimeConstraint> constraints = boundary_times(surface, {-1.0, 0.5});
  constraints.push_back({ring(6), 1.0});
  try {
    solve_time_field(surface, constraints);
    FAIL() << "a ridge is a place where knitting would have to end";
  } catch (const NotKnittable& refused) {
    const Problem* ridge = find_problem(refused.problems(), "false-extremum");
    ASSERT_NE(ridge, nullptr);
    EXPECT_EQ(ridge->elements.vertices, ring(6));
  }
}

TEST(TimeField, AnOpeningInPassingIsRefused) {
  // A hole half-way up with the time half-way: cloth below it is earlier, cloth above it later.
  const Surface surface = surface_of(
      without_quads(tube({24, 12}), {5 * 24 + 3, 5 * 24 + 4, 6 * 24 + 3, 6 * 24 + 4}));
  try {
    field_of(surface, {-1.0, 0.0, 1.0});
    FAIL();
  } catch (const NotKnittable& refused) {
    const Problem* passing = find_problem(refused.problems(), "boundary-in-passing");
    ASSERT_NE(passing, nullptr);
    EXPECT_EQ(passing->elements.boundaries, std::vector<int>{1});
  }
  // As an end it is fine, and splits the cloth once.
  EXPECT_EQ(field_of(surface, {-1.0, 1.0, 1.0}).check.saddles, 1);
}

TEST(TimeFieldSolver, ChangedTimesNeedNoNewSolver) {
  const Surface surface = surface_of(tube({24, 12}));
  const TimeFieldSolver solver(
      surface, {surface.boundaries[0].vertices, surface.boundaries[1].vertices});
  const std::vector<double> full = solver.solve({-1.0, 1.0}), upper = solver.solve({0.0, 1.0});
  for (std::size_t v = 0; v < full.size(); ++v)
    EXPECT_NEAR(upper[v], 0.5 * (full[v] + 1.0), 1e-9);  // interpolation is linear in the times
  EXPECT_EQ(solver.solve({-1.0, 1.0}), full);
}

TEST(TimeFieldSolver, RefusesUsageThatMakesNoSense) {
  const Surface surface = surface_of(tube({24, 12}));
  EXPECT_THROW(TimeFieldSolver(surface, {}), InvalidInput);
  EXPECT_THROW(TimeFieldSolver(surface, {{0, 100000}}), InvalidInput);
  EXPECT_THROW(TimeFieldSolver(surface, {{0, 1}, {1, 2}}), InvalidInput);
  EXPECT_THROW(TimeFieldSolver(surface, {{0, 1}}).solve({0.0, 1.0}), InvalidInput);
  EXPECT_THROW(TimeFieldSolver(surface, {{0, 1}}).solve({std::nan("")}), InvalidInput);
  const Surface apart = surface_of(side_by_side(tube(), tube(), {100.0, 0.0, 0.0}));
  EXPECT_THROW(TimeFieldSolver(apart, {{0, 1}}), InvalidInput);
}

}  // namespace
}  // namespace meshknit
