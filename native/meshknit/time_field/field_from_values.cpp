#include "meshknit/time_field/field_from_values.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <queue>
#include <utility>

#include "meshknit/core/error.h"
#include "meshknit/surface/fast_marching.h"

namespace meshknit {
namespace {

constexpr double infinity = std::numeric_limits<double>::infinity();

// By which a filled place rises from vertex to vertex, of the field's range: far less than a row.
constexpr double rise = 1e-7;

// Filling a pit can leave a dip beside a cut peak, of the size of `rise`.
constexpr int most_rounds = 20;

using VertexHandle = TriangleMesh::VertexHandle;

void stretch(std::vector<double>& time) {
  const auto [low, high] = std::minmax_element(time.begin(), time.end());
  const double least = *low, range = *high - *low;
  if (!(range > 0.0)) return;
  for (double& t : time) t = std::clamp(-1.0 + 2.0 * (t - least) / range, -1.0, 1.0);
}

// How much later the cloth beside a boundary is than the boundary, on the whole, and its mean value.
struct RimValues {
  double mean = 0.0, rise = 0.0;
};

RimValues rim_values(const Surface& surface, const BoundaryLoop& loop,
                     const std::vector<double>& values) {
  RimValues rim;
  double beside = 0.0;
  int neighbours = 0;
  for (const int v : loop.vertices) {
    rim.mean += values[v] / static_cast<double>(loop.vertices.size());
    for (const auto w : surface.mesh.vv_range(VertexHandle(v)))
      if (!surface.mesh.is_boundary(w)) {
        beside += values[w.idx()];
        ++neighbours;
      }
  }
  if (neighbours > 0) rim.rise = beside / neighbours - rim.mean;
  return rim;
}

// Which boundaries are starts: those with later cloth beside them; if that is none or all, the earliest
// one is, or the latest one is not.
std::vector<char> find_starts(const Surface& surface, const std::vector<double>& values) {
  std::vector<RimValues> rims;
  for (const BoundaryLoop& loop : surface.boundaries)
    rims.push_back(rim_values(surface, loop, values));
  std::vector<char> starts;
  for (const RimValues& rim : rims) starts.push_back(rim.rise >= 0.0 ? 1 : 0);
  const auto earlier = [](const RimValues& a, const RimValues& b) { return a.mean < b.mean; };
  const auto [first, last] = std::minmax_element(rims.begin(), rims.end(), earlier);
  if (std::count(starts.begin(), starts.end(), 1) == 0) starts[first - rims.begin()] = 1;
  if (std::count(starts.begin(), starts.end(), 0) == 0) starts[last - rims.begin()] = 0;
  return starts;
}

void level_boundaries(const Surface& surface, std::vector<double>& values) {
  const std::vector<char> starts = find_starts(surface, values);
  for (std::size_t b = 0; b < starts.size(); ++b) {
    const std::vector<int>& loop = surface.boundaries[b].vertices;
    const auto earlier = [&](int v, int w) { return values[v] < values[w]; };
    const auto [first, last] = std::minmax_element(loop.begin(), loop.end(), earlier);
    const double time = values[starts[b] ? *first : *last];
    for (const int v : loop) values[v] = time;
  }
}

// Raises every vertex that has no way down to a boundary from which it only rises; with sign -1 lowers
// those without a way up. Returns how many were changed.
int flood(const Surface& surface, const std::vector<char>& starts, double sign, double step,
          std::vector<double>& time) {
  const TriangleMesh& mesh = surface.mesh;
  using Entry = std::pair<double, int>;
  std::priority_queue<Entry, std::vector<Entry>, std::greater<>> queue;
  std::vector<char> reached(mesh.n_vertices(), 0);
  for (std::size_t b = 0; b < starts.size(); ++b)
    for (const int v : surface.boundaries[b].vertices) {
      if ((starts[b] != 0) == (sign > 0.0)) queue.push({sign * time[v], v});
      reached[v] = 1;
    }
  int changed = 0;
  while (!queue.empty()) {
    const auto [level, v] = queue.top();
    queue.pop();
    for (const auto h : mesh.vv_range(VertexHandle(v))) {
      const int w = h.idx();
      if (reached[w]) continue;
      reached[w] = 1;
      if (sign * time[w] < level + step) {
        time[w] = sign * (level + step);
        ++changed;
      }
      queue.push({sign * time[w], w});
    }
  }
  return changed;
}

}  // namespace

std::vector<double> field_from_values(const Surface& surface,
                                      const std::vector<double>& values) {
  if (values.size() != surface.mesh.n_vertices())
    throw InvalidInput("field_from_values: one value is needed for every mesh vertex");
  for (const double value : values)
    if (!std::isfinite(value)) throw InvalidInput("field_from_values: a value is not a number");
  std::vector<double> time = values;
  if (surface.boundaries.size() > 1) level_boundaries(surface, time);
  stretch(time);
  return time;
}

std::vector<double> distance_field(const Surface& surface, const std::vector<int>& starts) {
  const int boundaries = static_cast<int>(surface.boundaries.size());
  std::vector<MarchSeed> seeds;
  std::vector<char> is_start(surface.boundaries.size(), 0);
  for (const int b : starts) {
    if (b < 0 || b >= boundaries)
      throw InvalidInput("distance_field: there is no boundary " + std::to_string(b));
    is_start[b] = 1;
    for (const int v : surface.boundaries[b].vertices) seeds.push_back({v, 0.0});
  }
  const auto count = std::count(is_start.begin(), is_start.end(), 1);
  if (count == 0 || count == boundaries)
    throw InvalidInput("distance_field: some boundaries must be starts, and others not");
  std::vector<double> time(surface.mesh.n_vertices(), infinity);
  march(
      surface.mesh, edge_lengths(surface.mesh), seeds, infinity, [](int) { return true; },
      time);
  for (int b = 0; b < boundaries; ++b) {
    if (is_start[b]) continue;
    double latest = 0.0;
    for (const int v : surface.boundaries[b].vertices) latest = std::max(latest, time[v]);
    for (const int v : surface.boundaries[b].vertices) time[v] = latest;
  }
  stretch(time);
  return time;
}

std::vector<double> blended(const std::vector<double>& from, const std::vector<double>& to,
                            double share) {
  if (from.size() != to.size())
    throw InvalidInput("blended: both fields need a time for the same vertices");
  std::vector<double> time;
  for (std::size_t v = 0; v < from.size(); ++v)
    time.push_back((1.0 - share) * from[v] + share * to[v]);
  return time;
}

MendedField mend_field(const Surface& surface, const std::vector<double>& time) {
  if (time.size() != surface.mesh.n_vertices())
    throw InvalidInput("mend_field: one time is needed for every mesh vertex");
  MendedField mended;
  mended.time = time;
  if (time.empty() || surface.boundaries.size() < 2) return mended;
  const auto [low, high] = std::minmax_element(time.begin(), time.end());
  const double range = *high - *low;
  const std::vector<char> starts = find_starts(surface, time);
  for (int round = 0; round < most_rounds; ++round) {
    const int filled = flood(surface, starts, 1.0, rise * range, mended.time);
    const int cut = flood(surface, starts, -1.0, rise * range, mended.time);
    if (filled + cut == 0) break;
  }
  for (std::size_t v = 0; v < time.size(); ++v) {
    const double change = std::abs(mended.time[v] - time[v]);
    mended.changed += change > 0.0;
    if (range > 0.0) mended.most = std::max(mended.most, change / range);
  }
  return mended;
}

}  // namespace meshknit
