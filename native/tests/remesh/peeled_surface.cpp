#include "remesh/peeled_surface.h"

#include "meshknit/remesh/geodesic_band.h"
#include "meshknit/remesh/slicing.h"
#include "meshknit/remesh/start_cycle.h"
#include "meshknit/remesh/trimming.h"
#include "meshknit/surface/refine.h"

namespace meshknit {

PeeledSurface::PeeledSurface(const TimedShape& shape, double longest_edge) {
  RefinedMesh fine = refine_mesh(shape.surface.mesh, shape.time, longest_edge);
  source_face = fine.source_face;
  state.mesh = fine.mesh;
  state.time = fine.value;
  state.crossing.assign(state.mesh.n_edges(), 0.5);
  for (const auto e : state.mesh.edges())
    state.edge_length.push_back(state.mesh.calc_edge_length(e));
  const int a = shape.surface.boundaries[0].vertices[0];
  const int b = shape.surface.boundaries[1].vertices[0];
  const bool a_first = state.time[a] < state.time[b];
  state.knitted = mark_boundary(state.mesh, a_first ? a : b);
  last = mark_boundary(state.mesh, a_first ? b : a);
  active = cycle_beside(state, state.knitted);
}

void PeeledSurface::peel(int rows, double height) {
  GeodesicBand band(state);
  Slicer slicer(state, last);
  Trimmer trimmer(state, last);
  for (int row = 0; row < rows; ++row) {
    band.measure(active, 1.2 * height);
    const std::vector<NextCycle> cycles = slicer.slice(band, active, height);
    active = trimmer.trim(band, active, cycles.front().cycle, height, {});
  }
}

int open_characteristic(const PeelState& state) {
  const auto open = [&](int v) { return state.knitted[v] == 0; };
  int characteristic = 0;
  for (const auto v : state.mesh.vertices()) characteristic += open(v.idx());
  for (const auto e : state.mesh.edges()) {
    const int h = 2 * e.idx();
    characteristic -= open(state.from(h)) && open(state.to(h));
  }
  for (const auto f : state.mesh.faces()) {
    bool all = true;
    for (const auto v : state.mesh.fv_range(f)) all = all && open(v.idx());
    characteristic += all;
  }
  return characteristic;
}

}  // namespace meshknit
