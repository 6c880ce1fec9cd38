#include "meshknit/remesh/start_cycle.h"

namespace meshknit {

std::vector<char> mark_boundary(const TriangleMesh& mesh, int vertex) {
  std::vector<char> marked(mesh.n_vertices(), 0);
  auto h = mesh.halfedge_handle(TriangleMesh::VertexHandle(vertex));
  const auto first = h;
  do {
    marked[mesh.to_vertex_handle(h).idx()] = 1;
    h = mesh.next_halfedge_handle(h);
  } while (h != first);
  return marked;
}

Cycle cycle_beside(PeelState& state, const std::vector<char>& boundary) {
  constexpr double at = 0.005;
  const auto knitted = [&](int v) { return boundary[v] != 0; };
  Cycle cycle;
  int first = -1;
  for (const auto h : state.mesh.halfedges())
    if (boundary[state.from(h.idx())] && !boundary[state.to(h.idx())]) {
      first = h.idx();
      break;
    }
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
