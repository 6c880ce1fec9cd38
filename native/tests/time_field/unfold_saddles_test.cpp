#include "meshknit/time_field/unfold_saddles.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cmath>

#include "meshknit/time_field/reeb_graph.h"
#include "meshknit/time_field/time_field.h"
#include "shapes.h"

namespace meshknit {
namespace {

constexpr double pi = 3.14159265358979323846;
constexpr int sectors = 18, rings = 6;

// Two round plates that are joined along their rims but for six gaps: three that start and three
// that end, in turn. By symmetry all six tubes meet in the middle of each plate.
class OnAPillow : public testing::Test {
 protected:
  OnAPillow() {
    // Per plate: the middle, a ring of six vertices, then rings of eighteen. Every third spoke
    // runs through a vertex of the ring of six, and through the middle of a gap.
    const int plate = 7 + sectors * (rings - 1);
    const auto index = [&](int side, int r, int s) {
      s %= sectors;
      if (r == rings && s % 3 != 1) side = 0;  // joined
      if (r == 0) return side * plate;
      return side * plate + (r == 1 ? 1 + s / 3 : 7 + (r - 2) * sectors + s);
    };
    VertexArray vertices = VertexArray::Zero(2 * plate, 3);
    std::vector<std::array<int, 3>> faces;
    const auto add_face = [&](int a, int b, int c) {
      if (a != b && b != c && c != a) faces.push_back({a, b, c});
    };
    for (int side = 0; side < 2; ++side)
      for (int r = 0; r < rings; ++r)
        for (int s = 0; s < sectors; ++s) {
          const int a = index(side, r, s), b = index(side, r + 1, s),
                    c = index(side, r + 1, s + 1), d = index(side, r, s + 1);
          add_face(a, b, c);
          add_face(a, c, d);
          const double angle = 2.0 * pi * (r == 0 ? 3 * (s / 3) + 1 : s) / sectors;
          vertices.row(b) << 10.0 * (r + 1) * std::cos(angle), 10.0 * (r + 1) * std::sin(angle),
              r + 1 == rings ? 0.0
              : side == 0    ? 4.0
                             : -4.0;
          vertices(a, 2) = side == 0 ? 4.0 : -4.0;
        }
    // The gaps' middles lie apart, so that the gaps are open.
    for (int s = 1; s < sectors; s += 3) {
      vertices(index(0, rings, s), 2) = 4.0;
      vertices(index(1, rings, s), 2) = -4.0;
    }
    FaceArray rows(static_cast<Eigen::Index>(faces.size()), 3);
    for (std::size_t f = 0; f < faces.size(); ++f) {
      const bool lower = f >= faces.size() / 2;
      rows.row(static_cast<Eigen::Index>(f)) << faces[f][0], faces[f][lower ? 2 : 1],
          faces[f][lower ? 1 : 2];
    }
    surface = make_surface(vertices, rows);
    std::vector<TimeConstraint> constraints;
    for (const BoundaryLoop& rim : surface.boundaries) {
      Eigen::Vector3d middle = Eigen::Vector3d::Zero();
      for (const int v : rim.vertices) middle += surface.mesh.point(OpenMesh::VertexHandle(v));
      const double angle = std::atan2(middle.y(), middle.x()) - 2.0 * pi / sectors;
      constraints.push_back({rim.vertices, std::cos(3.0 * angle) > 0.0 ? 1.0 : -1.0});
    }
    time = solve_time_field(surface, constraints).time;
  }

  int steepest_index() const {
    int least = 0;
    for (const ReebEvent& event : reeb_graph(surface.mesh, time).events)
      least = std::min(least, event.index);
    return least;
  }

  Surface surface;
  std::vector<double> time;
};

TEST_F(OnAPillow, TwoSaddlesOfThreeWaysBecomeFourOfTwo) {
  ASSERT_EQ(surface.boundaries.size(), 6u);
  ASSERT_EQ(steepest_index(), -2) << "the middle of a plate must be a threefold saddle";
  const std::vector<double> before = time;
  EXPECT_EQ(unfold_saddles(surface.mesh, time), 2);
  EXPECT_EQ(steepest_index(), -1);
  const TimeFieldCheck check = check_time_field(surface, time);
  EXPECT_FALSE(has_errors(check.problems));
  EXPECT_EQ(check.extrema, 0);
  EXPECT_EQ(check.saddles, check.expected_saddles);
  // Only a few neighbours of the two middles move.
  int moved = 0;
  for (std::size_t v = 0; v < time.size(); ++v) moved += time[v] != before[v];
  EXPECT_GE(moved, 2);
  EXPECT_LE(moved, 6);
}

TEST_F(OnAPillow, RimsKeepTheirTimes) {
  unfold_saddles(surface.mesh, time);
  for (const BoundaryLoop& rim : surface.boundaries)
    for (const int v : rim.vertices) EXPECT_EQ(std::abs(time[v]), 1.0);
}

TEST(UnfoldSaddles, LeavesSimpleOnesAlone) {
  TimedShape shape = timed(trousers());
  const std::vector<double> before = shape.time;
  EXPECT_EQ(unfold_saddles(shape.surface.mesh, shape.time), 0);
  EXPECT_EQ(shape.time, before);
}

}  // namespace
}  // namespace meshknit
