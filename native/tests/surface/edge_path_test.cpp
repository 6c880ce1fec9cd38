#include "meshknit/surface/edge_path.h"

#include <gtest/gtest.h>

#include "meshknit/core/error.h"
#include "surface/test_meshes.h"

namespace meshknit {
namespace {

// A 6 x 4 grid of 5 mm squares with the square in the middle missing; vertex (column, row) is
// row * 7 + column. Diagonals go from the lower left to the upper right.
Surface plate() {
  const MeshArrays arrays = grid(6, 4, 5.0, [](int c, int r) { return c == 3 && r == 1; });
  return make_surface(arrays.vertices, arrays.faces, {0.5, 6});
}
int at(int column, int row) { return row * 7 + column; }

TEST(NearestVertex, IsTheNearestAndOnATieTheLowest) {
  const Surface surface = plate();
  EXPECT_EQ(nearest_vertex(surface, {9.0, 6.0, 3.0}), at(2, 1));
  EXPECT_EQ(nearest_vertex(surface, {2.5, 0.0, 0.0}), at(0, 0));  // half-way to (1, 0)
  EXPECT_EQ(nearest_vertex(Surface(), {0.0, 0.0, 0.0}), -1);
}

TEST(NearestBoundary, IsTheRimThatAPersonPointsAt) {
  const Surface surface = plate();
  ASSERT_EQ(surface.boundaries.size(), 2u);
  EXPECT_EQ(nearest_boundary(surface, {-5.0, 10.0, 0.0}),
            0);  // beside the plate: its outer rim
  EXPECT_EQ(nearest_boundary(surface, {17.5, 7.5, 20.0}), 1);  // above the hole
  EXPECT_EQ(nearest_boundary(Surface(), {0.0, 0.0, 0.0}), -1);
}

TEST(EdgePath, FollowsEdgesTheShortestWay) {
  const Surface surface = plate();
  EXPECT_EQ(edge_path(surface, {at(0, 0), at(2, 2)}),
            (std::vector<int>{at(0, 0), at(1, 1), at(2, 2)}))
      << "along the diagonals";
  EXPECT_EQ(edge_path(surface, {at(2, 3), at(5, 3)}),
            (std::vector<int>{at(2, 3), at(3, 3), at(4, 3), at(5, 3)}));
}

TEST(EdgePath, OnEquallyShortWaysTheLowerIndexWins) {
  // Falling two columns right and one row down, no diagonal helps: three sides in any order,
  // and the predecessors with the lowest indices are those in the lower row.
  EXPECT_EQ(edge_path(plate(), {at(0, 1), at(2, 0)}),
            (std::vector<int>{at(0, 1), at(0, 0), at(1, 0), at(2, 0)}));
}

TEST(EdgePath, AClosedChainComesBackWithoutRepeatingItsStart) {
  const Surface surface = plate();
  const std::vector<int> ring =
      edge_path(surface, {at(1, 0), at(3, 0), at(3, 1), at(1, 1)}, true);
  EXPECT_EQ(ring,
            (std::vector<int>{at(1, 0), at(2, 0), at(3, 0), at(3, 1), at(2, 1), at(1, 1)}));
}

TEST(EdgePath, PointsThatFallOnOneVertexCountOnce) {
  const Surface surface = plate();
  EXPECT_EQ(edge_path(surface, {at(1, 1), at(1, 1), at(2, 1), at(2, 1)}),
            (std::vector<int>{at(1, 1), at(2, 1)}));
  EXPECT_EQ(edge_path(surface, {at(1, 1), at(1, 1)}, true), std::vector<int>{at(1, 1)});
  EXPECT_TRUE(edge_path(surface, {}).empty());
}

TEST(EdgePath, RefusesVerticesThatAreNotThere) {
  EXPECT_THROW(edge_path(plate(), {0, 1000}), InvalidInput);
  EXPECT_THROW(edge_path(plate(), {-1}), InvalidInput);
}

TEST(EdgePath, RefusesToJumpBetweenPieces) {
  const MeshArrays arrays = side_by_side(tube(), tube(), {100.0, 0.0, 0.0});
  const Surface surface = make_surface(arrays.vertices, arrays.faces);
  EXPECT_THROW(edge_path(surface, {0, static_cast<int>(tube().vertices.rows())}), InvalidInput);
}

}  // namespace
}  // namespace meshknit
