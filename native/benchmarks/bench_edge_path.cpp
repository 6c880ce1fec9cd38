// What a person waits for while dragging: the shortest way along the edges of a square cloth, from
// its middle to a vertex near it, and from corner to corner, which is the worst of a drag.

#include <algorithm>
#include <cstdio>

#include "meshknit/surface/edge_graph.h"
#include "table.h"

namespace {

using namespace meshknit;

void measure_cloth(int side) {
  VertexArray positions(side * side, 3);
  EdgeArray edges(2 * side * (side - 1), 2);
  int edge = 0;
  for (int r = 0; r < side; ++r)
    for (int c = 0; c < side; ++c) {
      const int v = r * side + c;
      positions.row(v) << c, r, 0.0;
      if (c + 1 < side) edges.row(edge++) << v, v + 1;
      if (r + 1 < side) edges.row(edge++) << v, v + side;
    }
  double begin = seconds();
  EdgeGraph graph(positions, edges);
  const double built = seconds() - begin;
  const auto slowest = [&](int from, int to) {
    double most = 0.0;
    for (int times = 0; times < 20; ++times) {
      begin = seconds();
      graph.path(from, to);
      most = std::max(most, seconds() - begin);
    }
    return most * 1e3;
  };
  const int middle = side / 2 * side + side / 2, step = side / 20;
  std::printf("%8d %10.1f %10.2f %14.2f\n", side * side, built * 1e3,
              slowest(middle, middle + step * side + step), slowest(0, side * side - 1));
}

void measure(int, char**) {
  std::printf("vertices   build ms    near ms  corners ms (slowest of 20)\n");
  for (const int side : {32, 100, 316, 632}) measure_cloth(side);
}

}  // namespace

int main(int argc, char** argv) { return run_benchmark(argc, argv, measure); }
