#include "meshknit/remesh/slicing.h"

#include <algorithm>
#include <cmath>

namespace meshknit {
namespace {

// Crossings keep this far from vertices, as a fraction of their edge.
constexpr double clear_of_vertices = 1e-3;

}  // namespace

Slicer::Slicer(const PeelState& state, const KnitLimits& limits)
    : state_(state), limits_(limits), seen_(state.mesh.n_edges(), 0) {}

std::vector<NextCycle> Slicer::slice(const GeodesicBand& band,
                                     const std::vector<const Cycle*>& actives,
                                     const RowLevel& level) {
  const std::vector<int> crossed = crossed_edges(band, level);
  std::vector<NextCycle> cycles;
  for (const int first : crossed) {
    if (seen_[first >> 1]) continue;
    NextCycle next;
    const auto inner = [&](int v) { return below(band, level, v); };
    for (int h = first; !seen_[h >> 1]; h = next_crossing(state_.mesh, h, inner)) {
      seen_[h >> 1] = 1;
      add_crossing(band, actives, level, h, next);
    }
    measure_cycle(state_, next.cycle);
    cycles.push_back(std::move(next));
  }
  for (const NextCycle& next : cycles)
    for (const EdgeCrossing& c : next.cycle.crossings) seen_[c.halfedge >> 1] = 0;
  std::stable_sort(cycles.begin(), cycles.end(), [](const NextCycle& a, const NextCycle& b) {
    return a.cycle.length() > b.cycle.length();
  });
  return cycles;
}

std::vector<int> Slicer::crossed_edges(const GeodesicBand& band, const RowLevel& level) const {
  std::vector<int> crossed;
  for (const int v : band.reached()) {
    const bool v_below = below(band, level, v);
    for (const auto h : state_.mesh.voh_range(TriangleMesh::VertexHandle(v))) {
      const int w = state_.to(h.idx());
      if (v_below && !below(band, level, w)) crossed.push_back(h.idx());
      // Beyond the end of a tube other tubes may be under way: only its own cycle counts.
      if (!v_below && state_.knitted[w] && band.cycle_across(h.idx() >> 1) >= 0)
        crossed.push_back(state_.mesh.opposite_halfedge_handle(h).idx());
    }
  }
  std::sort(crossed.begin(), crossed.end());
  return crossed;
}

void Slicer::add_crossing(const GeodesicBand& band, const std::vector<const Cycle*>& actives,
                          const RowLevel& level, int h, NextCycle& next) const {
  const int u = state_.from(h), w = state_.to(h);
  // Along an edge that the active cycle crosses too, distance grows from there.
  const bool from_active = state_.knitted[u] != 0;
  const double start = from_active ? state_.crossing[h >> 1] : 0.0;
  const double d_u = from_active ? 0.0 : band.distance(u);
  const double d_w = std::min(band.distance(w), d_u + state_.length(h));
  // How far below the row u and above it w lie.
  const double under = level.height(from_active ? w : u, d_u) - d_u;
  const double over = d_w - level.height(w, d_w);
  const double along = under + over > 0.0 ? std::clamp(under / (under + over), 0.0, 1.0) : 1.0;
  double t = start + along * (1.0 - start);
  if (!limits_.may_knit(w)) t = std::min(t, limits_.plan().end_fraction(state_, u, w));
  t = std::clamp(t, std::min(std::max(start, clear_of_vertices), 1.0 - clear_of_vertices),
                 1.0 - clear_of_vertices);
  next.cycle.crossings.push_back({h, t});
  next.time.push_back(state_.time[u] + t * (state_.time[w] - state_.time[u]));
  const double part = start < 1.0 ? (t - start) / (1.0 - start) : 1.0;
  next.gap.push_back(d_u + part * (d_w - d_u));
  const int across = band.cycle_across(h >> 1);
  const int source = across >= 0 ? across : band.nearest_cycle(u);
  const double foot_u = across >= 0 ? band.place_across(h >> 1) : band.foot(u);
  const bool one_cycle = std::isfinite(band.distance(w)) && band.nearest_cycle(w) == source;
  const double foot_w = one_cycle ? band.foot(w) : foot_u;
  const double length = actives[source]->length();
  next.source.push_back(source);
  next.foot.push_back(forward(0.0, foot_u + part * around(foot_u, foot_w, length), length));
}

}  // namespace meshknit
