#include "meshknit/time_field/reeb_graph.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <vector>

#include "meshknit/surface/edge_path.h"
#include "meshknit/time_field/time_field.h"
#include "random_surfaces.h"
#include "shapes.h"
#include "surface/test_meshes.h"

namespace meshknit {
namespace {

// What every Reeb graph keeps, whatever its field.
void expect_promises(const ReebGraph& graph, int genus) {
  int sum = 0;
  for (std::size_t e = 0; e < graph.events.size(); ++e) {
    const ReebEvent& event = graph.events[e];
    sum += event.index;
    if (e > 0) {
      EXPECT_LE(graph.events[e - 1].time, event.time);
    }
    for (const int arc : event.below) EXPECT_EQ(graph.arcs[arc].to, static_cast<int>(e));
    for (const int arc : event.above) EXPECT_EQ(graph.arcs[arc].from, static_cast<int>(e));
    for (const int vertex : event.vertices) EXPECT_EQ(graph.arc_of_vertex[vertex], -1);
  }
  for (const ReebArc& arc : graph.arcs) {
    EXPECT_LT(arc.from, arc.to);  // and so not later, but two saddles may tie
  }
  EXPECT_EQ(sum, 2 - 2 * genus);
}

int count_events(const ReebGraph& graph, std::size_t below, std::size_t above) {
  return static_cast<int>(
      std::count_if(graph.events.begin(), graph.events.end(), [&](const ReebEvent& event) {
        return event.below.size() == below && event.above.size() == above;
      }));
}

TEST(ReebGraph, OfATubeIsOneArcHoweverManyTimesAreEqual) {
  // Each ring of the mesh has one time: its vertices tie all round.
  const TriangleMesh mesh = half_edges(tube({24, 12}));
  std::vector<double> time;
  for (const auto v : mesh.vertices()) time.push_back(mesh.point(v).z());
  const ReebGraph graph = reeb_graph(mesh, time);
  expect_promises(graph, 0);
  ASSERT_EQ(graph.arcs.size(), 1u);
  ASSERT_EQ(graph.events.size(), 2u);
  EXPECT_TRUE(graph.events[0].is_start() && graph.events[0].has_boundary);
  EXPECT_TRUE(graph.events[1].is_end() && graph.events[1].has_boundary);
  // The two rims are events; the eleven rings between them belong to the tube.
  EXPECT_EQ(std::count(graph.arc_of_vertex.begin(), graph.arc_of_vertex.end(), 0), 11 * 24);
}

TEST(ReebGraph, OfTrousersPartsOnce) {
  const TimedShape shape = timed(trousers());
  const ReebGraph graph = reeb_graph(shape.surface.mesh, shape.time);
  expect_promises(graph, 0);
  EXPECT_EQ(graph.arcs.size(), 3u);
  EXPECT_EQ(graph.events.size(), 4u);
  EXPECT_EQ(count_events(graph, 1, 2), 1);
}

TEST(ReebGraph, OfTheSameUpsideDownMeetsOnce) {
  TimedShape shape = timed(trousers());
  for (double& t : shape.time) t = -t;
  const ReebGraph graph = reeb_graph(shape.surface.mesh, shape.time);
  expect_promises(graph, 0);
  EXPECT_EQ(count_events(graph, 2, 1), 1);
}

TEST(ReebGraph, OfAPiercedRingPartsAndMeets) {
  const TimedShape shape = timed(ring_torus());
  const ReebGraph graph = reeb_graph(shape.surface.mesh, shape.time);
  expect_promises(graph, 1);
  // From the lower hole to where the halves part, two halves, and on to the upper hole.
  EXPECT_EQ(graph.arcs.size(), 4u);
  EXPECT_EQ(count_events(graph, 1, 2), 1);
  EXPECT_EQ(count_events(graph, 2, 1), 1);
  const auto split = std::find_if(graph.events.begin(), graph.events.end(),
                                  [](const ReebEvent& e) { return e.above.size() == 2; });
  ASSERT_NE(split, graph.events.end());
  EXPECT_EQ(graph.arcs[split->above[0]].to, graph.arcs[split->above[1]].to);
}

TEST(ReebGraph, TakesPlacesApartThatAreReachedAtOneTime) {
  // A plate with three holes in a line, knit from its outer rim and the middle hole to the other two:
  // above and below the middle hole, at one time, the two starts meet. The mesh stays the same
  // turned by half, and so does the field if both halves are averaged.
  constexpr int wide = 44, high = 20;
  const MeshArrays arrays = grid(wide, high, 4.0, [](int column, int row) {
    const auto in_hole = [&](int from) { return column >= from && column < from + 4; };
    return row >= 8 && row < 12 && (in_hole(8) || in_hole(20) || in_hole(32));
  });
  const Surface plate = make_surface(arrays.vertices, arrays.faces);
  ASSERT_EQ(plate.boundaries.size(), 4u);
  std::vector<TimeConstraint> constraints;
  for (const double x : {0.0, 20.0 * 4.0, 8.0 * 4.0, 32.0 * 4.0}) {
    const double y = x == 0.0 ? 0.0 : 8.0 * 4.0;
    constraints.push_back({plate.boundaries[nearest_boundary(plate, {x, y, 0.0})].vertices,
                           x == 0.0 || x == 80.0 ? -1.0 : 1.0});
  }
  const std::vector<double> solved = solve_time_field(plate, constraints).time;
  std::vector<double> time = solved;
  for (std::size_t v = 0; v < time.size(); ++v) {
    const int turned = (wide + 1) * (high + 1) - 1 - plate.source_vertex[v];
    time[v] = 0.5 * (solved[v] + solved[plate.vertex_of_source[turned]]);
  }
  const ReebGraph graph = reeb_graph(plate.mesh, time);
  expect_promises(graph, 0);
  std::vector<double> saddle_times;
  for (const ReebEvent& event : graph.events)
    if (event.index < 0) saddle_times.push_back(event.time);
  ASSERT_EQ(saddle_times.size(), 2u);
  EXPECT_EQ(saddle_times[0], saddle_times[1]);
  // Whichever is taken first: the starts meet, then two tubes part.
  EXPECT_EQ(count_events(graph, 2, 1), 1);
  EXPECT_EQ(count_events(graph, 1, 2), 1);
}

TEST(ReebGraph, KeepsItsPromisesOnSurfacesThatNobodyDrew) {
  for (std::uint32_t seed = 0; seed < 12; ++seed) {
    SCOPED_TRACE(seed);
    const RandomSurface random = random_surface(seed);
    const ReebGraph graph = reeb_graph(random.timed.surface.mesh, random.timed.time);
    expect_promises(graph, random.handles);
    // Rims are the only starts and ends.
    EXPECT_EQ(std::count_if(graph.events.begin(), graph.events.end(),
                            [](const ReebEvent& e) { return e.is_start() || e.is_end(); }),
              static_cast<int>(random.shape.times.size()));
  }
}

}  // namespace
}  // namespace meshknit
