#include "meshknit/suggest/tips.h"

#include <algorithm>
#include <limits>
#include <numeric>

#include "meshknit/surface/disjoint_sets.h"
#include "meshknit/surface/point_distance.h"

namespace meshknit {
namespace {

constexpr double infinity = std::numeric_limits<double>::infinity();
constexpr int places = 12;

SurfacePoint at_vertex(const TriangleMesh& mesh, int v) {
  const TriangleMesh::VertexHandle vertex(v);
  return {(*mesh.cvf_iter(vertex)).idx(), mesh.point(vertex)};
}

int furthest(const std::vector<double>& distance) {
  return static_cast<int>(std::max_element(distance.begin(), distance.end()) -
                          distance.begin());
}

// Mean distance of every vertex to places far from each other.
std::vector<double> mean_distance(const TriangleMesh& mesh, RunContext* run) {
  const std::size_t n = mesh.n_vertices();
  std::vector<double> nearest(n, infinity), sum(n, 0.0);
  // The first place only serves to find the furthest one.
  int at = furthest(distance_from(mesh, at_vertex(mesh, 0), infinity));
  for (int k = 0; k < places; ++k) {
    report(run, 0.0);
    const std::vector<double> distance = distance_from(mesh, at_vertex(mesh, at), infinity);
    for (std::size_t v = 0; v < n; ++v) {
      nearest[v] = std::min(nearest[v], distance[v]);
      sum[v] += distance[v] / places;
    }
    at = furthest(nearest);
  }
  return sum;
}

}  // namespace

std::vector<Tip> find_tips(const TriangleMesh& mesh, RunContext* run) {
  const std::size_t n = mesh.n_vertices();
  if (n == 0) return {};
  const std::vector<double> mean = mean_distance(mesh, run);
  // Vertices join from the furthest inward. A limb ends where it meets one that reaches further.
  std::vector<int> order(n);
  std::iota(order.begin(), order.end(), 0);
  std::stable_sort(order.begin(), order.end(), [&](int a, int b) { return mean[a] > mean[b]; });
  DisjointSets sets(n);
  std::vector<int> peak(n, -1);  // per set: its furthest vertex
  std::vector<Tip> tips;
  const auto add = [&](int set, double prominence) {
    if (!mesh.is_boundary(TriangleMesh::VertexHandle(peak[set])))
      tips.push_back({peak[set], prominence});
  };
  const auto further = [&](int a, int b) {
    return mean[peak[a]] != mean[peak[b]] ? mean[peak[a]] > mean[peak[b]] : peak[a] < peak[b];
  };
  for (const int v : order) {
    peak[v] = v;
    for (const auto w : mesh.vv_range(TriangleMesh::VertexHandle(v))) {
      int a = sets.root(w.idx()), b = sets.root(v);
      if (peak[w.idx()] < 0 || a == b) continue;
      if (!further(a, b)) std::swap(a, b);
      // A vertex that joins a limb is no limb itself.
      if (peak[b] != v) add(b, mean[peak[b]] - mean[v]);
      const int furthest_of_both = peak[a];
      sets.unite(a, b);
      peak[sets.root(v)] = furthest_of_both;
    }
  }
  add(sets.root(0), infinity);
  std::stable_sort(tips.begin(), tips.end(), [](const Tip& a, const Tip& b) {
    return a.prominence != b.prominence ? a.prominence > b.prominence : a.vertex < b.vertex;
  });
  return tips;
}

}  // namespace meshknit
