#include "meshknit/remesh/active_cycle.h"

#include <algorithm>
#include <limits>

#include "meshknit/surface/segment.h"

namespace meshknit {
namespace {

double nearest_place(const Cycle& cycle, const Eigen::Vector3d& p) {
  double best = std::numeric_limits<double>::infinity(), place = 0.0;
  for (int i = 0; i < cycle.size(); ++i) {
    const Eigen::Vector3d &a = cycle.points[i], &b = cycle.points[(i + 1) % cycle.size()];
    const double t = nearest_along(a, b, p);
    const double distance = (a + t * (b - a) - p).squaredNorm();
    if (distance < best) {
      best = distance;
      place = cycle.arc_of({i, t});
    }
  }
  return place;
}

}  // namespace

void place_nodes(ActiveCycle& active, std::vector<int>& piece_of_edge) {
  const Cycle& cycle = active.cycle;
  const int n = cycle.size(), nodes = static_cast<int>(active.nodes.size());
  for (int i = 0; i < n; ++i) piece_of_edge[cycle.crossings[i].halfedge >> 1] = i;
  for (ActiveNode& node : active.nodes) {
    const int piece = piece_of_edge[node.halfedge >> 1];
    const bool same = piece >= 0 && cycle.crossings[piece].halfedge == node.halfedge &&
                      cycle.crossings[(piece + 1) % n].halfedge == node.next_halfedge;
    node.place = same ? cycle.arc_of({piece, node.along}) : nearest_place(cycle, node.position);
  }
  for (int i = 0; i < n; ++i) piece_of_edge[cycle.crossings[i].halfedge >> 1] = -1;

  // Where the cycle was changed two nodes may have come out of order: push the later one on.
  const double length = cycle.length(), least = 1e-6 * length / std::max(1, nodes);
  double at = 0.0;  // unrolled distance from node 0
  for (int i = 1; i < nodes; ++i) {
    const double from_before = around(active.nodes[i - 1].place, active.nodes[i].place, length);
    at += std::max(least, from_before);
    active.nodes[i].place = forward(0.0, active.nodes[0].place + at, length);
  }
}

}  // namespace meshknit
