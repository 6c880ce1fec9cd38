#include "meshknit/remesh/start_cycle.h"

#include <algorithm>

namespace meshknit {
namespace {

// Orders half edges by the positions of their ends.
bool before(const PeelState& state, int a, int b) {
  const auto less = [](const Eigen::Vector3d& p, const Eigen::Vector3d& q) {
    return std::lexicographical_compare(p.data(), p.data() + 3, q.data(), q.data() + 3);
  };
  const Eigen::Vector3d &p = state.point(state.from(a)), &q = state.point(state.from(b));
  return less(p, q) || (p == q && less(state.point(state.to(a)), state.point(state.to(b))));
}

}  // namespace

Cycle cycle_beside(PeelState& state, const std::vector<char>& boundary) {
  constexpr double at = 0.005;
  const auto knitted = [&](int v) { return boundary[v] != 0; };
  Cycle cycle;
  // Where the cycle begins decides where columns begin: by place, not by the mesh's numbering.
  int first = -1;
  for (const auto h : state.mesh.halfedges())
    if (boundary[state.from(h.idx())] && !boundary[state.to(h.idx())] &&
        (first < 0 || before(state, h.idx(), first)))
      first = h.idx();
  int h = first;
  do {
    cycle.crossings.push_back({h, at});
    state.crossing[h >> 1] = at;
    h = next_crossing(state.mesh, h, knitted);
  } while (h != first);
  measure_cycle(state, cycle);
  return cycle;
}

}  // namespace meshknit
