#include "meshknit/remesh/trimming.h"

#include <algorithm>
#include <cmath>

namespace meshknit {
namespace {

// Walls keep further from vertices than level sets do: their places are known less exactly.
constexpr double clear_of_vertices = 0.02;

// How far inside a region a place is, along the active cycle; negative outside.
double inside_by(const TrimRegion& r, double foot, double height, double length) {
  const double begin = r.begin_below + height * around(r.begin_below, r.begin_above, length);
  const double end = r.end_below + height * around(r.end_below, r.end_above, length);
  const double width = forward(begin, end, length), at = forward(begin, foot, length);
  return at <= width ? std::min(at, width - at) : -std::min(at - width, length - at);
}

double inside_by(const std::vector<TrimRegion>& regions, double foot, double height,
                 double length) {
  double most = -length;
  for (const TrimRegion& r : regions)
    most = std::max(most, inside_by(r, foot, std::min(height, 1.0), length));
  return most;
}

}  // namespace

Trimmer::Trimmer(PeelState& state, const KnitLimits& limits)
    : state_(state), limits_(limits), seen_(state.mesh.n_edges(), 0) {}

std::optional<Cycle> Trimmer::trim(const GeodesicBand& band, const Cycle& active,
                                   const Cycle& next, const RowLevel& level,
                                   const std::vector<TrimRegion>& regions,
                                   std::size_t largest_pocket) {
  const double length = active.length();
  const auto part = [&](int v) { return band.distance(v) / level.height(v, band.distance(v)); };
  const auto depth = [&](int v) {
    return regions.empty() ? length : inside_by(regions, band.foot(v), part(v), length);
  };
  std::vector<int> knitted_now;
  for (const int v : band.reached())
    if (limits_.may_knit(v) && part(v) < 1.0 && depth(v) > 0.0) knitted_now.push_back(v);
  std::vector<std::pair<int, double>> old_crossings;
  const auto cross_at = [&](int edge, double t) {
    old_crossings.push_back({edge, state_.crossing[edge]});
    state_.crossing[edge] = t;
  };
  for (const int v : knitted_now) state_.knitted[v] = 1;
  const std::vector<int> all_now = knitted_now;
  const auto now = [&](int v) { return std::binary_search(all_now.begin(), all_now.end(), v); };

  for (const EdgeCrossing& c : next.crossings)
    if (regions.empty() || now(state_.from(c.halfedge))) cross_at(c.halfedge >> 1, c.t);
  if (!regions.empty()) {
    for (const int u : all_now)
      for (const auto h : state_.mesh.voh_range(TriangleMesh::VertexHandle(u))) {
        const int w = state_.to(h.idx());
        if (state_.knitted[w] || !std::isfinite(band.distance(w))) continue;
        const double d_u = depth(u), d_w = depth(w);
        if (d_w >= 0.0) continue;
        const double wall =
            std::clamp(d_u / (d_u - d_w), clear_of_vertices, 1.0 - clear_of_vertices);
        const bool beyond = !limits_.may_knit(w) || part(w) >= 1.0;
        const double t = state_.crossing[h.idx() >> 1];
        cross_at(h.idx() >> 1, beyond ? std::min(t, wall) : wall);
      }
  }

  for (int attempt = 0; attempt < 10; ++attempt) {
    std::vector<Cycle> cycles = walk(front_edges(active, knitted_now));
    if (cycles.empty()) break;
    if (cycles.size() == 1) {
      newly_knitted_ =
          static_cast<int>(std::count_if(knitted_now.begin(), knitted_now.end(),
                                         [&](int v) { return state_.knitted[v] != 0; }));
      return std::move(cycles.front());
    }
    // The way on to the end of the tube is no pocket, whatever its length.
    std::stable_sort(cycles.begin(), cycles.end(),
                     [](const Cycle& a, const Cycle& b) { return a.length() < b.length(); });
    bool mended = false;
    for (const Cycle& island : cycles)
      mended = close_pocket(island, largest_pocket, knitted_now) ||
               reopen_island(island, all_now) || mended;
  }
  for (const int v : knitted_now) state_.knitted[v] = 0;
  for (auto old = old_crossings.rbegin(); old != old_crossings.rend(); ++old)
    state_.crossing[old->first] = old->second;
  newly_knitted_ = 0;
  return std::nullopt;
}

std::vector<int> Trimmer::front_edges(const Cycle& active,
                                      const std::vector<int>& knitted_now) {
  std::vector<int> crossed;
  for (const EdgeCrossing& c : active.crossings)
    if (!state_.knitted[state_.to(c.halfedge)] && state_.knitted[state_.from(c.halfedge)])
      crossed.push_back(c.halfedge);
  for (const int u : knitted_now)
    if (state_.knitted[u])
      for (const auto h : state_.mesh.voh_range(TriangleMesh::VertexHandle(u)))
        if (!state_.knitted[state_.to(h.idx())]) crossed.push_back(h.idx());
  std::sort(crossed.begin(), crossed.end());
  return crossed;
}

std::vector<Cycle> Trimmer::walk(const std::vector<int>& crossed) {
  const auto knitted = [&](int v) { return state_.knitted[v] != 0; };
  std::vector<Cycle> cycles;
  for (const int first : crossed) {
    if (seen_[first >> 1]) continue;
    Cycle cycle;
    for (int h = first; !seen_[h >> 1]; h = next_crossing(state_.mesh, h, knitted)) {
      seen_[h >> 1] = 1;
      cycle.crossings.push_back({h, state_.crossing[h >> 1]});
    }
    measure_cycle(state_, cycle);
    cycles.push_back(std::move(cycle));
  }
  for (const Cycle& cycle : cycles)
    for (const EdgeCrossing& c : cycle.crossings) seen_[c.halfedge >> 1] = 0;
  return cycles;
}

// Knits over the open vertices inside an island, if they are few and all of this tube.
bool Trimmer::close_pocket(const Cycle& island, std::size_t largest_pocket,
                           std::vector<int>& knitted_now) {
  std::vector<int> pocket{state_.to(island.crossings.front().halfedge)};
  if (state_.knitted[pocket[0]]) return true;  // closed already
  bool small = true;
  state_.knitted[pocket[0]] = 1;
  for (std::size_t i = 0; small && i < pocket.size(); ++i) {
    small = pocket.size() <= largest_pocket && limits_.may_knit(pocket[i]);
    for (const auto h : state_.mesh.voh_range(TriangleMesh::VertexHandle(pocket[i]))) {
      const int w = state_.to(h.idx());
      if (state_.knitted[w]) continue;
      state_.knitted[w] = 1;
      pocket.push_back(w);
    }
  }
  if (small)
    knitted_now.insert(knitted_now.end(), pocket.begin(), pocket.end());
  else
    for (const int v : pocket) state_.knitted[v] = 0;
  return small;
}

// Opens again what was knitted in this row without touching what was knitted before.
bool Trimmer::reopen_island(const Cycle& island, const std::vector<int>& all_now) {
  const auto now = [&](int v) { return std::binary_search(all_now.begin(), all_now.end(), v); };
  std::vector<int> blob{state_.from(island.crossings.front().halfedge)};
  if (!now(blob[0])) return false;
  state_.knitted[blob[0]] = 0;
  for (std::size_t i = 0; i < blob.size(); ++i)
    for (const auto h : state_.mesh.voh_range(TriangleMesh::VertexHandle(blob[i]))) {
      const int w = state_.to(h.idx());
      if (!state_.knitted[w]) continue;
      if (!now(w)) {
        for (const int v : blob) state_.knitted[v] = 1;
        return false;
      }
      state_.knitted[w] = 0;
      blob.push_back(w);
    }
  return true;
}

}  // namespace meshknit
