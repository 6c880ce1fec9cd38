#include "meshknit/time_field/field_from_values.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

#include "meshknit/core/error.h"
#include "meshknit/knit_graph/knit_graph_checks.h"
#include "meshknit/time_field/time_field.h"
#include "shapes.h"
#include "surface/test_meshes.h"

namespace meshknit {
namespace {

Surface surface_of(const std::string& name) {
  const ExampleShape shape = opened(example_shape(name));
  return make_surface(shape.vertices, shape.faces);
}

std::vector<double> heights(const Surface& surface) {
  std::vector<double> values;
  for (const auto v : surface.mesh.vertices()) values.push_back(surface.mesh.point(v).z());
  return values;
}

std::string errors_of(const Surface& surface, const std::vector<double>& time) {
  std::string text;
  for (const Problem& problem : check_time_field(surface, time).problems)
    if (problem.severity == Severity::error) text += problem.code + " ";
  return text;
}

TEST(FieldFromValues, HeightKnitsATubeFromBelow) {
  const Surface surface = surface_of("straight_tube");
  const std::vector<double> time = field_from_values(surface, heights(surface));
  EXPECT_EQ(errors_of(surface, time), "");
  for (const auto v : surface.mesh.vertices())
    EXPECT_NEAR(time[v.idx()], -1.0 + 2.0 * surface.mesh.point(v).z() / 120.0, 1e-9);
}

TEST(FieldFromValues, ASlantedRimHasOneTimeAllTheSame) {
  const ExampleShape shape = arrays_of_shape("tilted_cut");
  const Surface surface = make_surface(shape.vertices, shape.faces);
  const MendedField mended = mend_field(surface, field_from_values(surface, heights(surface)));
  EXPECT_EQ(errors_of(surface, mended.time), "");
}

TEST(FieldFromValues, ANumberThatIsNoneIsRefused) {
  const Surface surface = surface_of("straight_tube");
  std::vector<double> values = heights(surface);
  values[3] = std::nan("");
  EXPECT_THROW(field_from_values(surface, values), InvalidInput);
  values.pop_back();
  EXPECT_THROW(field_from_values(surface, values), InvalidInput);
}

TEST(DistanceField, KnitsATubeWithoutShortRows) {
  // Round a bend the harmonic field has short rows on the outside; the distance from the start has
  // none before its last rows.
  const Surface surface = surface_of("bent_tube");
  const std::vector<double> time = distance_field(surface, {0});
  const MendedField mended = mend_field(surface, time);
  ASSERT_EQ(errors_of(surface, mended.time), "");
  const KnitGraph graph = remesh(surface, mended.time);
  for (const Problem& problem : check_knit_graph(graph).problems)
    EXPECT_NE(problem.severity, Severity::error) << problem.message;
  double last_short = 1.0, last = -1.0;
  for (const KnitRow& row : graph.rows)
    for (const int node : row.nodes) {
      last = std::max(last, graph.nodes[node].time);
      if (!row.closed) last_short = std::min(last_short, graph.nodes[node].time);
    }
  EXPECT_GT(last_short, 0.0) << "short rows only where the end is met";
}

TEST(DistanceField, NeedsAStartAndAnEnd) {
  const Surface surface = surface_of("straight_tube");
  EXPECT_THROW(distance_field(surface, {}), InvalidInput);
  EXPECT_THROW(distance_field(surface, {0, 1}), InvalidInput);
  EXPECT_THROW(distance_field(surface, {2}), InvalidInput);
}

TEST(MendField, FillsAPitAndCutsAPeakAndNoMore) {
  const Surface surface = surface_of("straight_tube");
  std::vector<double> time = field_from_values(surface, heights(surface));
  // A pit and a peak half way up, of one vertex each.
  int pit = -1, peak = -1;
  for (const auto v : surface.mesh.vertices()) {
    const Eigen::Vector3d p = surface.mesh.point(v);
    if (std::abs(p.z() - 60.0) > 5.0) continue;
    if (p.x() > 29.0) pit = v.idx();
    if (p.x() < -29.0) peak = v.idx();
  }
  ASSERT_GE(pit, 0);
  ASSERT_GE(peak, 0);
  const std::vector<double> good = time;
  time[pit] -= 0.5;
  time[peak] += 0.5;
  ASSERT_NE(errors_of(surface, time), "");
  const MendedField mended = mend_field(surface, time);
  EXPECT_EQ(errors_of(surface, mended.time), "");
  EXPECT_EQ(mended.changed, 2) << "nothing else was wrong";
  // A pit overflows at its lowest neighbour, at most one ring of vertices from the true height.
  EXPECT_NEAR(mended.time[pit], good[pit], 0.15);
  EXPECT_NEAR(mended.time[peak], good[peak], 0.15);
}

TEST(MendField, LeavesAGoodFieldAlone) {
  const TimedShape shape = timed(opened(example_shape("teddy")));
  const MendedField mended = mend_field(shape.surface, shape.time);
  EXPECT_EQ(mended.changed, 0);
  EXPECT_EQ(mended.time, shape.time);
}

TEST(MendField, MakesHeightsAndDistancesOfAllExamplesKnittable) {
  for (const std::string& name : example_shape_names()) {
    const Surface surface = surface_of(name);
    const MendedField by_height =
        mend_field(surface, field_from_values(surface, heights(surface)));
    EXPECT_EQ(errors_of(surface, by_height.time), "") << name << " by height";
    const MendedField by_distance = mend_field(surface, distance_field(surface, {0}));
    EXPECT_EQ(errors_of(surface, by_distance.time), "") << name << " by distance";
  }
}

TEST(Blended, LiesBetweenBothFields) {
  EXPECT_EQ(blended({0.0, 1.0}, {1.0, -1.0}, 0.25), (std::vector<double>{0.25, 0.5}));
  EXPECT_THROW(blended({0.0}, {}, 0.5), InvalidInput);
}

}  // namespace
}  // namespace meshknit
