#include "meshknit/time_field/critical_spots.h"

#include <algorithm>
#include <array>

#include "meshknit/surface/disjoint_sets.h"

namespace meshknit {

TimeSpots spots_of_mesh(const TriangleMesh& mesh, const std::vector<double>& time,
                        RunContext* run) {
  const auto ends = [&](OpenMesh::EdgeHandle e) -> std::array<int, 2> {
    const auto half = mesh.halfedge_handle(e, 0);
    return {mesh.from_vertex_handle(half).idx(), mesh.to_vertex_handle(half).idx()};
  };
  DisjointSets sets(time.size());
  for (const auto e : mesh.edges()) {
    const auto [a, b] = ends(e);
    if (time[a] == time[b]) sets.unite(a, b);
  }

  report(run, 0.0);
  TimeSpots found;
  auto& [spots, spot_of] = found;
  spot_of.resize(time.size());
  for (std::size_t v = 0; v < time.size(); ++v) {
    const int root = sets.root(static_cast<int>(v));  // the lowest vertex, so it came before
    if (root == static_cast<int>(v)) {
      spot_of[v] = static_cast<int>(spots.size());
      spots.emplace_back();
    }
    spot_of[v] = spot_of[root];
    spots[spot_of[v]].vertices.push_back(static_cast<int>(v));
    ++spots[spot_of[v]].characteristic;
  }
  for (const auto e : mesh.edges()) {
    const auto [a, b] = ends(e);
    if (time[a] == time[b]) {
      --spots[spot_of[a]].characteristic;
    } else {
      spots[spot_of[time[a] < time[b] ? a : b]].has_later = true;
      spots[spot_of[time[a] < time[b] ? b : a]].has_earlier = true;
    }
  }
  report(run, 0.0);
  // Going round a spot, the sign changes wherever a face has one earlier and one later corner
  // besides it: every face with three times makes one change at its middle corner.
  for (const auto f : mesh.faces()) {
    std::array<int, 3> c{};
    int k = 0;
    for (const auto v : mesh.fv_range(f)) c[k++] = v.idx();
    std::sort(c.begin(), c.end(), [&](int a, int b) { return time[a] < time[b]; });
    if (time[c[0]] == time[c[2]])
      ++spots[spot_of[c[0]]].characteristic;
    else if (time[c[0]] < time[c[1]] && time[c[1]] < time[c[2]])
      ++spots[spot_of[c[1]]].sign_changes;
  }
  return found;
}

std::vector<TimeSpot> time_spots(const Surface& surface, const std::vector<double>& time,
                                 const std::vector<bool>& constant) {
  auto [spots, spot_of] = spots_of_mesh(surface.mesh, time);
  for (std::size_t b = 0; b < surface.boundaries.size(); ++b) {
    const auto& loop = surface.boundaries[b].vertices;
    if (constant[b]) {
      TimeSpot& spot = spots[spot_of[loop.front()]];
      spot.boundaries.push_back(static_cast<int>(b));
      ++spot.characteristic;  // the disk that fills it
    } else {
      for (const int v : loop) spots[spot_of[v]].on_varying_boundary = true;
    }
  }
  return std::move(spots);
}

}  // namespace meshknit
