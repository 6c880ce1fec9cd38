#include "meshknit/surface/edge_graph.h"

#include <gtest/gtest.h>

#include <cmath>
#include <limits>

#include "meshknit/core/error.h"
#include "surface/test_meshes.h"

namespace meshknit {
namespace {

// A cloth of w x h squares without diagonals, corners shaken; vertex (column, row) is
// row * (w + 1) + column.
struct Squares {
  VertexArray positions;
  EdgeArray edges;
};

Squares squares(int w, int h, double shake) {
  Squares cloth;
  Jitter jitter(7);
  cloth.positions.resize((w + 1) * (h + 1), 3);
  cloth.edges.resize(w * (h + 1) + h * (w + 1), 2);
  int edge = 0;
  for (int r = 0; r <= h; ++r)
    for (int c = 0; c <= w; ++c) {
      const int v = r * (w + 1) + c;
      cloth.positions.row(v) << c + shake * jitter.next(), r + shake * jitter.next(),
          shake * jitter.next();
      if (c < w) cloth.edges.row(edge++) << v, v + 1;
      if (r < h) cloth.edges.row(edge++) << v, v + w + 1;
    }
  return cloth;
}

double length(const Squares& cloth, const std::vector<int>& chain) {
  double sum = 0.0;
  for (std::size_t i = 1; i < chain.size(); ++i)
    sum += (cloth.positions.row(chain[i]) - cloth.positions.row(chain[i - 1])).norm();
  return sum;
}

// Distances from one vertex by going over all edges until nothing gets shorter.
std::vector<double> plain_distances(const Squares& cloth, int from) {
  std::vector<double> distance(cloth.positions.rows(), std::numeric_limits<double>::infinity());
  distance[from] = 0.0;
  for (bool shorter = true; shorter;) {
    shorter = false;
    for (int e = 0; e < cloth.edges.rows(); ++e)
      for (int end = 0; end < 2; ++end) {
        const int a = cloth.edges(e, end), b = cloth.edges(e, 1 - end);
        const double reached =
            distance[a] + (cloth.positions.row(a) - cloth.positions.row(b)).norm();
        if (reached < distance[b] - 1e-12) distance[b] = reached, shorter = true;
      }
  }
  return distance;
}

TEST(EdgeGraph, NoWayIsShorterHoweverOftenOneAsks) {
  const Squares cloth = squares(17, 11, 0.35);
  EdgeGraph graph(cloth.positions, cloth.edges);
  const int count = static_cast<int>(cloth.positions.rows());
  for (int from = 0; from < count; from += 29) {
    const std::vector<double> distance = plain_distances(cloth, from);
    for (int to = 0; to < count; ++to) {
      const std::vector<int> chain = graph.path(from, to);
      ASSERT_EQ(chain.front(), from);
      ASSERT_EQ(chain.back(), to);
      ASSERT_EQ(graph.edges_along(chain).size(), chain.size() - 1) << "every step is an edge";
      ASSERT_NEAR(length(cloth, chain), distance[to], 1e-9);
    }
  }
}

TEST(EdgeGraph, KeepsToTheEdgesOfSquares) {
  // Two right and two up: four sides, no diagonal. Of the six ways the one whose vertices are
  // reached from the lowest runs along the bottom first.
  const Squares cloth = squares(4, 4, 0.0);
  EXPECT_EQ(EdgeGraph(cloth.positions, cloth.edges).path(0, 12),
            (std::vector<int>{0, 1, 2, 7, 12}));
}

TEST(EdgeGraph, SaysSoWhereNothingLeads) {
  VertexArray positions(5, 3);
  positions << 0, 0, 0, 1, 0, 0, 5, 0, 0, 6, 0, 0, 9, 0, 0;
  EdgeArray edges(2, 2);
  edges << 0, 1, 2, 3;
  EdgeGraph graph(positions, edges);
  EXPECT_TRUE(graph.path(0, 3).empty());
  EXPECT_EQ(graph.path(4, 4), std::vector<int>{4});
  EXPECT_THROW(graph.path(0, 5), InvalidInput);
  EXPECT_THROW(graph.path(-1, 0), InvalidInput);
  EXPECT_THROW(graph.edges_along({1, 2}), InvalidInput);
  edges(0, 0) = 5;
  EXPECT_THROW(EdgeGraph(positions, edges), InvalidInput);
}

TEST(EdgeGraph, BearsEdgesWithoutLengthAndPointsThatAreNoPlace) {
  // A row of vertices 0 - 1 = 2 - 3, where 1 and 2 lie on each other, and 4 that is nowhere.
  VertexArray positions(5, 3);
  positions << 0, 0, 0, 1, 0, 0, 1, 0, 0, 2, 0, 0, std::nan(""), 0, 0;
  EdgeArray edges(4, 2);
  edges << 2, 3, 1, 2, 0, 1, 3, 4;
  EdgeGraph graph(positions, edges);
  EXPECT_EQ(graph.path(0, 3), (std::vector<int>{0, 1, 2, 3}));
  EXPECT_EQ(graph.edges_along({0, 1, 2, 3}), (std::vector<int>{2, 1, 0}));
  EXPECT_EQ(graph.path(3, 0), (std::vector<int>{3, 2, 1, 0}));
  EXPECT_TRUE(graph.path(0, 4).empty());
  EXPECT_TRUE(graph.path(4, 0).empty());
}

}  // namespace
}  // namespace meshknit
