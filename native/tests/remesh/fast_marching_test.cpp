#include "meshknit/surface/fast_marching.h"

#include <gtest/gtest.h>

#include <cmath>
#include <limits>

#include "remesh/peeled_surface.h"

namespace meshknit {
namespace {

constexpr double infinity = std::numeric_limits<double>::infinity();

TEST(FastMarching, FindsTheHeightThatIsLeftOfAStraightTube) {
  const PeeledSurface peeled(shape_named("straight_tube"));
  std::vector<MarchSeed> rim;
  for (const int v : peeled.plan.reeb.events.back().vertices) rim.push_back({v, 0.0});
  std::vector<double> distance(peeled.state.mesh.n_vertices(), infinity);
  march(
      peeled.state.mesh, peeled.state.edge_length, rim, 40.0, [](int) { return true; },
      distance);
  for (const auto v : peeled.state.mesh.vertices()) {
    const double left = 120.0 - peeled.state.point(v.idx()).z();
    if (left > 41.0) {
      EXPECT_TRUE(std::isinf(distance[v.idx()])) << "beyond the limit";
    } else if (left < 39.0) {
      EXPECT_NEAR(distance[v.idx()], left, 0.02 * left + 1e-9);
    }
  }
}

// Triangles far longer than high once made the march go round for ever.
TEST(FastMarching, EndsOnVeryObtuseTriangles) {
  PeelState state;
  for (int row = 0; row < 6; ++row)
    for (int i = 0; i < 12; ++i) state.mesh.add_vertex({10.0 * i + 37.0 * row, 1.0 * row, 0.0});
  const auto v = [](int row, int i) { return TriangleMesh::VertexHandle(12 * row + i); };
  for (int row = 0; row + 1 < 6; ++row)
    for (int i = 0; i + 1 < 12; ++i) {
      state.mesh.add_face(v(row, i), v(row, i + 1), v(row + 1, i + 1));
      state.mesh.add_face(v(row, i), v(row + 1, i + 1), v(row + 1, i));
    }
  for (const auto e : state.mesh.edges())
    state.edge_length.push_back(state.mesh.calc_edge_length(e));
  std::vector<MarchSeed> seeds;
  for (int i = 0; i < 12; ++i) seeds.push_back({i, 0.0});
  std::vector<double> distance(72, infinity);
  march(
      state.mesh, state.edge_length, seeds, 1e6, [](int) { return true; }, distance);
  for (const double d : distance) EXPECT_TRUE(std::isfinite(d));
}

}  // namespace
}  // namespace meshknit
