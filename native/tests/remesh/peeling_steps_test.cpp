#include <gtest/gtest.h>

#include <cmath>
#include <set>

#include "meshknit/core/error.h"
#include "meshknit/remesh/active_cycle.h"
#include "meshknit/remesh/geodesic_band.h"
#include "meshknit/remesh/sampling.h"
#include "meshknit/remesh/slicing.h"
#include "meshknit/remesh/trimming.h"
#include "meshknit/remesh/tube_end.h"
#include "remesh/peeled_surface.h"

namespace meshknit {
namespace {

constexpr double row = 3.46;

// A straight tube: 40-gon of radius 30, 120 mm long, its circumference is 80 * 30 * sin(pi /
// 40).
const double circumference = 2400.0 * std::sin(3.14159265358979323846 / 40.0);

struct Step {
  explicit Step(const char* name)
      : peeled(shape_named(name)), band(peeled.state, *peeled.limits) {}
  NextCycle slice(double level) {
    band.measure({&peeled.active}, 1.2 * level);
    Slicer slicer(peeled.state, *peeled.limits);
    const std::vector<NextCycle> cycles =
        slicer.slice(band, {&peeled.active}, RowLevel::of_height(level));
    EXPECT_EQ(cycles.size(), 1u);
    return cycles.front();
  }
  PeeledSurface peeled;
  GeodesicBand band;
};

TEST(Front, ACycleClosesAndCrossesEveryEdgeOnceInNeighbouringTriangles) {
  for (const std::string& name : shape_names()) {
    SCOPED_TRACE(name);
    PeeledSurface peeled(shape_named(name));
    peeled.peel(5);
    const Cycle& cycle = peeled.active;
    std::set<int> edges;
    for (int i = 0; i < cycle.size(); ++i) {
      const int h = cycle.crossings[i].halfedge;
      EXPECT_TRUE(edges.insert(h >> 1).second);
      EXPECT_TRUE(peeled.state.knitted[peeled.state.from(h)]);
      EXPECT_FALSE(peeled.state.knitted[peeled.state.to(h)]);
      const auto knitted = [&](int v) { return peeled.state.knitted[v] != 0; };
      EXPECT_EQ(next_crossing(peeled.state.mesh, h, knitted),
                cycle.crossings[(i + 1) % cycle.size()].halfedge);
    }
  }
}

TEST(Front, PlacesGoRoundTheCycle) {
  EXPECT_DOUBLE_EQ(forward(9.0, 1.0, 10.0), 2.0);
  EXPECT_DOUBLE_EQ(forward(1.0, 9.0, 10.0), 8.0);
  EXPECT_DOUBLE_EQ(forward(0.0, -12.0, 10.0), 8.0);
  EXPECT_DOUBLE_EQ(around(1.0, 9.0, 10.0), -2.0);
  PeeledSurface peeled(shape_named("straight_tube"));
  const Cycle& cycle = peeled.active;
  for (const double place : {0.0, 1.0, 77.7, cycle.length() - 1e-9}) {
    EXPECT_NEAR(cycle.arc_of(cycle.at(place)), place, 1e-9);
    EXPECT_NEAR(cycle.arc_of(cycle.at(place + cycle.length())), place, 1e-9);
  }
}

TEST(Slicing, TheNextCycleOfATubeIsItsCrossSectionARowHigher) {
  Step step("straight_tube");
  const NextCycle next = step.slice(row);
  EXPECT_NEAR(next.cycle.length(), circumference, 0.1);
  for (int i = 0; i < next.cycle.size(); ++i) {
    EXPECT_NEAR(next.cycle.points[i].z(), row, 0.02);
    EXPECT_NEAR(next.gap[i], row, 0.02);
    // Time rises evenly from -1 at the bottom to 1 at 120 mm.
    EXPECT_NEAR(next.time[i], -1.0 + next.cycle.points[i].z() / 60.0, 1e-6);
  }
}

TEST(Slicing, TheOpenSurfaceLiesToTheLeftOfTheCycle) {
  // Normals point out and the open surface is above: the cycle goes anticlockwise seen from
  // above.
  Step step("straight_tube");
  const NextCycle next = step.slice(row);
  double turned = 0.0;
  for (int i = 0; i < next.cycle.size(); ++i) {
    const Eigen::Vector3d &a = next.cycle.points[i],
                          &b = next.cycle.points[(i + 1) % next.cycle.size()];
    turned += a.x() * b.y() - a.y() * b.x();
  }
  EXPECT_GT(turned, 0.0);
}

TEST(Slicing, FeetGoRoundTheActiveCycleOnce) {
  for (const char* name : {"straight_tube", "cone", "widening_cone", "bent_tube"}) {
    SCOPED_TRACE(name);
    Step step(name);
    const NextCycle next = step.slice(row);
    const double length = step.peeled.active.length();
    double gone = 0.0;
    for (int i = 0; i < next.cycle.size(); ++i)
      gone += around(next.foot[i], next.foot[(i + 1) % next.cycle.size()], length);
    EXPECT_NEAR(gone, length, 1e-6);
  }
}

TEST(Trimming, WholeRowsLeaveATube) {
  for (const std::string& name : shape_names()) {
    SCOPED_TRACE(name);
    PeeledSurface peeled(shape_named(name));
    for (int k = 0; k < 8; ++k) {
      peeled.peel(1);
      EXPECT_EQ(open_characteristic(peeled.state), 0);
    }
  }
}

TEST(Trimming, AShortRowCutsOutItsPartAndLeavesATube) {
  Step step("straight_tube");
  step.peeled.peel(2);
  const Cycle active = step.peeled.active;
  const NextCycle next = step.slice(row);
  Trimmer trimmer(step.peeled.state, *step.peeled.limits);
  // A quarter of the way round, between two upright walls.
  const double quarter = 0.25 * active.length();
  const Cycle cycle = trimmer
                          .trim(step.band, active, next.cycle, RowLevel::of_height(row),
                                {{10.0, 10.0, 10.0 + quarter, 10.0 + quarter}})
                          .value();
  EXPECT_GT(trimmer.newly_knitted(), 0);
  EXPECT_EQ(open_characteristic(step.peeled.state), 0);
  // The new cycle climbs a wall of a row's height twice.
  EXPECT_NEAR(cycle.length(), active.length() + 2.0 * row, 0.6 * row);
  double upper = 0.0;
  for (int i = 0; i < cycle.size(); ++i)
    if (cycle.points[i].z() > 2.75 * row) upper += cycle.arc[i + 1] - cycle.arc[i];
  EXPECT_NEAR(upper, quarter, row);
}

TEST(TubeEnd, ARowIsTwoCoursesHighUntilTheLastRowsShareTheRest) {
  PeeledSurface peeled(shape_named("straight_tube"));
  const auto rest = [&] {
    return rest_of_tube(peeled.state, peeled.plan, 0, peeled.active, row);
  };
  EXPECT_DOUBLE_EQ(rest().height, row);
  EXPECT_FALSE(rest().near);

  // 28 rows end at 96.88 mm: the remaining 23.12 mm are 6.68 rows, so seven of 3.30 mm.
  peeled.peel(28);
  const RestOfTube shared = rest();
  EXPECT_NEAR(shared.height, 23.12 / 7.0, 0.05);
  EXPECT_EQ(shared.rows, 7);
  peeled.peel(5, shared.height);
  EXPECT_EQ(rest().rows, 2);
  EXPECT_TRUE(rest().near);
  peeled.peel(1, shared.height);
  EXPECT_EQ(rest().rows, 1);
}

// The active cycle of a tube with this many nodes spread evenly on it.
ActiveCycle with_nodes(const PeeledSurface& peeled, int count) {
  ActiveCycle active;
  active.cycle = peeled.active;
  for (int i = 0; i < count; ++i) {
    const double place = (i + 0.4) * active.cycle.length() / count;
    const CyclePoint p = active.cycle.at(place);
    ActiveNode node;
    node.node = i;
    node.halfedge = active.cycle.crossings[p.piece].halfedge;
    node.next_halfedge = active.cycle.crossings[(p.piece + 1) % active.cycle.size()].halfedge;
    node.along = p.along;
    node.position = active.cycle.position(p);
    active.nodes.push_back(node);
  }
  return active;
}

TEST(ActiveCycle, NodesKeepTheirPlaces) {
  PeeledSurface peeled(shape_named("straight_tube"));
  peeled.peel(1);
  ActiveCycle active = with_nodes(peeled, 51);
  std::vector<int> scratch(peeled.state.mesh.n_edges(), -1);
  place_nodes(active, scratch);
  for (int i = 0; i < 51; ++i)
    EXPECT_NEAR(active.nodes[i].place, (i + 0.4) * active.cycle.length() / 51, 1e-6);
}

TEST(ActiveCycle, NodesWhosePieceIsGoneGoToTheNearestPlaceInOrder) {
  PeeledSurface peeled(shape_named("straight_tube"));
  peeled.peel(1);
  ActiveCycle active = with_nodes(peeled, 51);
  peeled.peel(1);
  active.cycle = peeled.active;
  std::vector<int> scratch(peeled.state.mesh.n_edges(), -1);
  place_nodes(active, scratch);
  const double length = active.cycle.length();
  for (int i = 0; i < 51; ++i) {
    const double step =
        forward(active.nodes[i].place, active.nodes[(i + 1) % 51].place, length);
    EXPECT_GT(step, 0.0);
    EXPECT_LT(step, 2.0 * length / 51);
  }
}

TEST(Sampling, ATubesNextRowStandsOnTheNodesBelow) {
  Step step("straight_tube");
  step.peeled.peel(1);
  ActiveCycle active = with_nodes(step.peeled, 51);
  std::vector<int> scratch(step.peeled.state.mesh.n_edges(), -1);
  place_nodes(active, scratch);
  const NextCycle next = step.slice(row);
  const std::vector<NodeImage> images = images_on_next(active, 0, next);
  const std::vector<double> places = sample_next_row(active, next, images, 3.66, 4);
  ASSERT_EQ(places.size(), 51u);
  for (const NodeImage& image : images) {
    const Eigen::Vector3d above = next.cycle.position(next.cycle.at(image.place));
    double nearest = 1e9;
    for (const double place : places)
      nearest = std::min(nearest, (next.cycle.position(next.cycle.at(place)) - above).norm());
    EXPECT_LT(nearest, 0.4) << "a ninth of a stitch";
  }
}

TEST(Sampling, AVeryDifferentRowIsHeldToWhatCanBeLinked) {
  Step step("straight_tube");
  step.peeled.peel(1);
  ActiveCycle active = with_nodes(step.peeled, 20);
  std::vector<int> scratch(step.peeled.state.mesh.n_edges(), -1);
  place_nodes(active, scratch);
  const NextCycle next = step.slice(row);
  const std::vector<NodeImage> images = images_on_next(active, 0, next);
  EXPECT_EQ(sample_next_row(active, next, images, 3.66, 4).size(), 40u)
      << "51 wanted, 2 a node";
  for (ActiveNode& node : active.nodes) node.single = true;
  EXPECT_EQ(sample_next_row(active, next, images, 3.66, 4).size(), 20u) << "singles take one";
}

}  // namespace
}  // namespace meshknit
