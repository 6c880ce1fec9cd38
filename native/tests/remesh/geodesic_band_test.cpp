#include "meshknit/remesh/geodesic_band.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

#include "meshknit/remesh/slicing.h"
#include "remesh/exact_distances.h"
#include "remesh/peeled_surface.h"

namespace meshknit {
namespace {

constexpr double row = 3.46;  // 2 l_c

int a_face_of(const TriangleMesh& mesh, int vertex) {
  for (const auto f : mesh.vf_range(TriangleMesh::VertexHandle(vertex))) return f.idx();
  return -1;
}

// 99th percentile of the absolute differences.
double p99(std::vector<double> a, const std::vector<double>& b) {
  for (std::size_t i = 0; i < a.size(); ++i) a[i] = std::abs(a[i] - b[i]);
  std::sort(a.begin(), a.end());
  return a[(a.size() * 99) / 100];
}

struct DeepInside {
  const char* shape;
  int rows;  // to peel first
};
class ExactBand : public testing::TestWithParam<DeepInside> {};
// Half way round the bend; in the sock's heel, which is wider than the leg and bends; in the
// narrow middle of a surface that is a saddle everywhere.
INSTANTIATE_TEST_SUITE_P(GeodesicBand, ExactBand,
                         testing::Values(DeepInside{"bent_tube", 22}, DeepInside{"sock", 38},
                                         DeepInside{"hourglass", 17}),
                         [](const auto& place) { return place.param.shape; });

TEST_P(ExactBand, AgreesWithAnExactMethodWithinAHundredthOfARow) {
  const TimedShape shape = shape_named(GetParam().shape);
  PeeledSurface peeled(shape);
  peeled.peel(GetParam().rows);
  GeodesicBand band(peeled.state, *peeled.limits);
  band.measure({&peeled.active}, 1.2 * row);

  std::vector<MeshPlace> vertices;
  std::vector<double> ours;
  for (const int v : band.reached()) {
    if (band.distance(v) < 0.8 || band.distance(v) > 1.2 * row) continue;
    vertices.push_back({a_face_of(peeled.state.mesh, v), peeled.state.point(v)});
    ours.push_back(band.distance(v));
  }
  ASSERT_GE(vertices.size(), 100u);
  EXPECT_LE(p99(exact_distances(shape, peeled, vertices), ours), 0.01 * row);

  // The next cycle is a level set: all of it lies one row away.
  Slicer slicer(peeled.state, *peeled.limits);
  const NextCycle next = slicer.slice(band, {&peeled.active}, RowLevel::of_height(row)).front();
  std::vector<MeshPlace> crossings;
  for (int i = 0; i < next.cycle.size(); ++i) {
    const auto h = TriangleMesh::HalfedgeHandle(next.cycle.crossings[i].halfedge);
    crossings.push_back({peeled.state.mesh.face_handle(h).idx(), next.cycle.points[i]});
  }
  EXPECT_LE(p99(exact_distances(shape, peeled, crossings), next.gap), 0.01 * row);
}

TEST(GeodesicBand, OnAnUprightTubeIsTheHeightAboveTheCycle) {
  const TimedShape shape = shape_named("straight_tube");
  PeeledSurface peeled(shape);
  GeodesicBand band(peeled.state, *peeled.limits);
  band.measure({&peeled.active}, 10.0);
  for (const int v : band.reached()) {
    if (band.distance(v) > 10.0) continue;
    // The first cycle lies within 0.005 of an edge, 0.014 mm, of the rim at z = 0.
    EXPECT_NEAR(band.distance(v), peeled.state.point(v).z(), 0.015);
  }
}

TEST(GeodesicBand, FindsEveryVertexWithinItsLimitAndForgetsTheOnesOfLastTime) {
  const TimedShape shape = shape_named("straight_tube");
  PeeledSurface peeled(shape);
  GeodesicBand band(peeled.state, *peeled.limits);
  for (const double limit : {20.0, 7.0}) {
    band.measure({&peeled.active}, limit);
    for (const auto v : peeled.state.mesh.vertices()) {
      const double height = peeled.state.point(v.idx()).z();
      if (height > 0.0 && height < limit - 0.01) {
        EXPECT_LT(band.distance(v.idx()), limit);
      }
      // A bit beyond: no vertex is reached that no edge joins with the band.
      if (height > limit + 2.9) {
        EXPECT_TRUE(std::isinf(band.distance(v.idx())));
      }
    }
  }
}

TEST(GeodesicBand, KnowsThePlaceStraightBelow) {
  const TimedShape shape = shape_named("straight_tube");
  PeeledSurface peeled(shape);
  GeodesicBand band(peeled.state, *peeled.limits);
  band.measure({&peeled.active}, 8.0);
  for (const int v : band.reached()) {
    const Eigen::Vector3d foot = peeled.active.position(peeled.active.at(band.foot(v)));
    const Eigen::Vector3d above = peeled.state.point(v) - foot;
    // Where the first cycle zigzags its nearest corner may lie a little aside.
    EXPECT_LT(std::hypot(above.x(), above.y()), 0.05 + 0.1 * band.distance(v));
  }
}

}  // namespace
}  // namespace meshknit
