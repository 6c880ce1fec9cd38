#include "meshknit/time_field/unfold_saddles.h"

#include <algorithm>

namespace meshknit {
namespace {

using VertexHandle = TriangleMesh::VertexHandle;

std::vector<int> ring_of(const TriangleMesh& mesh, int v) {
  std::vector<int> ring;
  for (const auto w : mesh.vv_range(VertexHandle(v))) ring.push_back(w.idx());
  return ring;
}

int sign_changes(const std::vector<int>& ring, const std::vector<double>& time, double level) {
  int changes = 0;
  const std::size_t n = ring.size();
  for (std::size_t k = 0; k < n; ++k)
    changes += (time[ring[k]] < level) != (time[ring[(k + 1) % n]] < level);
  return changes;
}

bool has_tie(const std::vector<int>& ring, const std::vector<double>& time, double level) {
  return std::any_of(ring.begin(), ring.end(), [&](int w) { return time[w] == level; });
}

bool is_extremum(const TriangleMesh& mesh, const std::vector<double>& time, int v) {
  const std::vector<int> ring = ring_of(mesh, v);
  const auto lower = [&](int w) { return time[w] < time[v]; };
  const auto higher = [&](int w) { return time[w] > time[v]; };
  return std::none_of(ring.begin(), ring.end(), lower) ||
         std::none_of(ring.begin(), ring.end(), higher);
}

// Lowers the run of later neighbours that begins at ring[begin]; undoes it and returns false if a
// vertex nearby would become an extremum.
bool lower_run(const TriangleMesh& mesh, const std::vector<int>& ring, std::size_t begin, int v,
               std::vector<double>& time) {
  const std::size_t n = ring.size();
  std::vector<int> run;
  for (std::size_t k = begin; time[ring[k % n]] > time[v]; ++k) run.push_back(ring[k % n]);
  const double before = time[ring[(begin + n - 1) % n]],
               after = time[ring[(begin + run.size()) % n]];
  const double level = time[v] - 0.25 * (time[v] - std::max(before, after));
  std::vector<double> old;
  for (const int w : run) {
    if (mesh.is_boundary(VertexHandle(w))) return false;
    old.push_back(time[w]);
  }
  for (const int w : run) time[w] = level;
  bool fine = level < time[v];
  for (const int w : run)
    for (const int x : ring_of(mesh, w))
      fine = fine && (mesh.is_boundary(VertexHandle(x)) || !is_extremum(mesh, time, x));
  if (!fine)
    for (std::size_t k = 0; k < run.size(); ++k) time[run[k]] = old[k];
  return fine;
}

bool unfold(const TriangleMesh& mesh, int v, std::vector<double>& time) {
  const std::vector<int> ring = ring_of(mesh, v);
  const std::size_t n = ring.size();
  for (std::size_t k = 0; k < n; ++k)
    if (time[ring[k]] > time[v] && time[ring[(k + n - 1) % n]] < time[v] &&
        lower_run(mesh, ring, k, v, time))
      return true;
  return false;
}

}  // namespace

int unfold_saddles(const TriangleMesh& mesh, std::vector<double>& time) {
  int unfolded = 0;
  for (const auto vertex : mesh.vertices()) {
    const int v = vertex.idx();
    if (mesh.is_boundary(vertex)) continue;
    const std::vector<int> ring = ring_of(mesh, v);
    while (!has_tie(ring, time, time[v]) && sign_changes(ring, time, time[v]) > 4 &&
           unfold(mesh, v, time))
      ++unfolded;
  }
  return unfolded;
}

}  // namespace meshknit
