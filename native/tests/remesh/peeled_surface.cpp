#include "remesh/peeled_surface.h"

#include "meshknit/remesh/geodesic_band.h"
#include "meshknit/remesh/slicing.h"
#include "meshknit/remesh/start_cycle.h"
#include "meshknit/remesh/trimming.h"
#include "meshknit/surface/refine.h"

namespace meshknit {
namespace {

constexpr double row_height = 3.46;

}  // namespace

PeeledSurface::PeeledSurface(const TimedShape& shape, double longest_edge) {
  RefinedMesh fine = refine_mesh(shape.surface.mesh, shape.time, longest_edge);
  source_face = fine.source_face;
  state.mesh = fine.mesh;
  state.time = fine.value;
  state.crossing.assign(state.mesh.n_edges(), 0.5);
  for (const auto e : state.mesh.edges())
    state.edge_length.push_back(state.mesh.calc_edge_length(e));
  plan = plan_sweep(state, row_height);
  limits = std::make_unique<KnitLimits>(plan);
  limits->open(0);
  state.knitted.assign(state.mesh.n_vertices(), 0);
  for (const int v : plan.reeb.events.front().vertices)
    state.knitted[v] = state.mesh.is_boundary(TriangleMesh::VertexHandle(v));
  active = cycle_beside(state, state.knitted);
}

void PeeledSurface::peel(int rows, double height) {
  GeodesicBand band(state, *limits);
  Slicer slicer(state, *limits);
  Trimmer trimmer(state, *limits);
  const RowLevel level = RowLevel::of_height(height);
  for (int row = 0; row < rows; ++row) {
    band.measure({&active}, 1.2 * height);
    const std::vector<NextCycle> cycles = slicer.slice(band, {&active}, level);
    active = trimmer.trim(band, active, cycles.front().cycle, level, {}).value();
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
