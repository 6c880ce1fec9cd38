#include "meshknit/remesh/distance_to_end.h"

#include <gtest/gtest.h>

#include <cmath>

#include "remesh/peeled_surface.h"

namespace meshknit {
namespace {

TEST(DistanceToEnd, IsTheHeightThatIsLeftOfAStraightTube) {
  const PeeledSurface peeled(shape_named("straight_tube"));
  const std::vector<double> distance = distance_to(peeled.state, peeled.last, 40.0);
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
TEST(DistanceToEnd, EndsOnVeryObtuseTriangles) {
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
  std::vector<char> marked(72, 0);
  for (int i = 0; i < 12; ++i) marked[i] = 1;
  for (const double d : distance_to(state, marked, 1e6)) EXPECT_TRUE(std::isfinite(d));
}

}  // namespace
}  // namespace meshknit
