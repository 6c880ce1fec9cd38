#include "meshknit/remesh/peel.h"

#include <algorithm>

#include "meshknit/surface/refine.h"
#include "meshknit/surface/reorder.h"
#include "meshknit/time_field/rim_ties.h"
#include "meshknit/time_field/unfold_saddles.h"

namespace meshknit {
namespace {

// Longest edge of the fine mesh, as a fraction of the smaller stitch dimension: rows bend no more
// sharply than that.
constexpr double fine_edge = 0.9;

PeelState fine_state(const Surface& surface, const std::vector<double>& time, double edge,
                     std::vector<int>& source_face, RunContext* run) {
  std::vector<double> unfolded = time;
  unfold_saddles(surface.mesh, unfolded);
  RefinedMesh fine = refine_mesh(surface.mesh, unfolded, edge, run);
  part_from_rims(fine.mesh, fine.value);
  reorder_by_value(fine, run);
  for (const int face : fine.source_face) source_face.push_back(surface.source_face[face]);
  report(run, 0.0);
  PeelState state;
  state.mesh = std::move(fine.mesh);
  state.time = std::move(fine.value);
  state.knitted.assign(state.mesh.n_vertices(), 0);
  state.crossing.assign(state.mesh.n_edges(), 0.5);
  state.edge_length.resize(state.mesh.n_edges());
  for (const auto e : state.mesh.edges())
    state.edge_length[e.idx()] = state.mesh.calc_edge_length(e);
  return state;
}

}  // namespace

Peel::Peel(const Surface& surface, const std::vector<double>& time, const RemeshOptions& given,
           const std::vector<int>& apart, RunContext* run)
    : options(given),
      row_height(2.0 * given.stitch_height),
      state(fine_state(surface, time, fine_edge * std::min(given.stitch_width, row_height),
                       source_face, run)),
      plan(plan_sweep(state, row_height, apart, run)),
      limits(plan),
      band(state, limits),
      slicer(state, limits),
      trimmer(state, limits),
      builder(state, given.stitch_width, given.stitch_height),
      piece_of_edge(state.mesh.n_edges(), -1) {}

std::vector<int> Peel::faces_near(int vertex) const {
  std::vector<int> faces;
  for (const auto f : state.mesh.vf_range(TriangleMesh::VertexHandle(vertex)))
    faces.push_back(source_face[f.idx()]);
  std::sort(faces.begin(), faces.end());
  faces.erase(std::unique(faces.begin(), faces.end()), faces.end());
  return faces;
}

}  // namespace meshknit
