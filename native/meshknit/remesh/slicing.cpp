#include "meshknit/remesh/slicing.h"

#include <algorithm>
#include <cmath>

namespace meshknit {
namespace {

// Crossings keep this far from vertices, as a fraction of their edge.
constexpr double clear_of_vertices = 1e-3;

}  // namespace

Slicer::Slicer(const PeelState& state, const std::vector<char>& last)
    : state_(state), last_(last), seen_(state.mesh.n_edges(), 0) {}

std::vector<NextCycle> Slicer::slice(const GeodesicBand& band, const Cycle& active,
                                     double level) {
  const auto below = [&](int v) {
    return state_.knitted[v] || (!last_[v] && band.distance(v) < level);
  };
  std::vector<int> crossed;
  for (const int v : band.reached()) {
    const bool v_below = below(v);
    for (const auto h : state_.mesh.voh_range(TriangleMesh::VertexHandle(v))) {
      const int w = state_.to(h.idx());
      if (v_below && !below(w)) crossed.push_back(h.idx());
      if (!v_below && state_.knitted[w])
        crossed.push_back(state_.mesh.opposite_halfedge_handle(h).idx());
    }
  }
  std::sort(crossed.begin(), crossed.end());

  std::vector<NextCycle> cycles;
  for (const int first : crossed) {
    if (seen_[first >> 1]) continue;
    NextCycle next;
    for (int h = first; !seen_[h >> 1]; h = next_crossing(state_.mesh, h, below)) {
      seen_[h >> 1] = 1;
      const int u = state_.from(h), w = state_.to(h);
      // Along an edge that the active cycle crosses too, distance grows from there.
      const bool from_active = state_.knitted[u];
      const double start = from_active ? state_.crossing[h >> 1] : 0.0;
      const double d_u = from_active ? 0.0 : band.distance(u);
      const double d_w = std::min(band.distance(w), d_u + state_.length(h));
      double along = d_w > d_u ? (level - d_u) / (d_w - d_u) : 1.0;
      along = std::clamp(along, 0.0, 1.0);
      const double t = std::clamp(start + along * (1.0 - start),
                                  std::max(start, clear_of_vertices), 1.0 - clear_of_vertices);
      next.cycle.crossings.push_back({h, t});
      next.time.push_back(state_.time[u] + t * (state_.time[w] - state_.time[u]));
      const double part = start < 1.0 ? (t - start) / (1.0 - start) : 1.0;
      next.gap.push_back(d_u + part * (d_w - d_u));
      const bool foot_at_w = std::isfinite(band.distance(w));
      const double foot_u = from_active ? band.foot(w) : band.foot(u);
      const double foot_w = foot_at_w ? band.foot(w) : foot_u;
      next.foot.push_back(forward(0.0, foot_u + part * around(foot_u, foot_w, active.length()),
                                  active.length()));
    }
    measure_cycle(state_, next.cycle);
    cycles.push_back(std::move(next));
  }
  for (const int h : crossed) seen_[h >> 1] = 0;
  std::stable_sort(cycles.begin(), cycles.end(), [](const NextCycle& a, const NextCycle& b) {
    return a.cycle.length() > b.cycle.length();
  });
  return cycles;
}

}  // namespace meshknit
