#include "meshknit/surface/doubled_vertices.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdint>
#include <utility>

#include "meshknit/surface/disjoint_sets.h"

namespace meshknit {
namespace {

using Cell = std::array<std::int64_t, 3>;

Cell cell_of(const Eigen::Vector3d& point, double size) {
  Cell cell;
  for (int k = 0; k < 3; ++k) cell[k] = static_cast<std::int64_t>(std::floor(point[k] / size));
  return cell;
}

// Groups the given vertices by place: those within the tolerance of each other, and their
// chains.
DisjointSets group_by_place(const VertexArray& vertices, const std::vector<int>& candidates,
                            double tolerance) {
  const Eigen::RowVector3d origin = vertices.row(candidates.front());
  const auto point = [&](int v) -> Eigen::Vector3d { return (vertices.row(v) - origin); };
  const double size = 4.0 * tolerance;
  std::vector<std::pair<Cell, int>> cells;
  for (const int v : candidates) cells.push_back({cell_of(point(v), size), v});
  std::sort(cells.begin(), cells.end());

  DisjointSets places(static_cast<std::size_t>(vertices.rows()));
  for (const int v : candidates) {
    const Eigen::Vector3d reach = Eigen::Vector3d::Constant(tolerance);
    const Cell low = cell_of(point(v) - reach, size), high = cell_of(point(v) + reach, size);
    for (auto x = low[0]; x <= high[0]; ++x)
      for (auto y = low[1]; y <= high[1]; ++y)
        for (auto z = low[2]; z <= high[2]; ++z) {
          const Cell cell = {x, y, z};
          auto near = std::lower_bound(cells.begin(), cells.end(), std::make_pair(cell, -1));
          for (; near != cells.end() && near->first == cell && near->second < v; ++near)
            if ((point(near->second) - point(v)).norm() <= tolerance)
              places.unite(near->second, v);
        }
  }
  return places;
}

// An open edge with its ends ordered by place.
struct OpenEdge {
  std::array<int, 2> place, vertex;
  int face = 0;
  int partner = -1;
};

bool same_places(const OpenEdge& a, const OpenEdge& b) { return a.place == b.place; }

// The edges whose partners form one other rim of the same piece, all the way round.
std::vector<bool> edges_of_cuts(const std::vector<OpenEdge>& edges, DisjointSets& pieces,
                                std::size_t vertex_count) {
  DisjointSets rims(vertex_count);
  for (const OpenEdge& e : edges) rims.unite(e.vertex[0], e.vertex[1]);
  constexpr int kUnknown = -1, kSeveral = -2;
  std::vector<int> partner_rim(vertex_count, kUnknown);
  for (const OpenEdge& e : edges) {
    int& partner = partner_rim[rims.root(e.vertex[0])];
    const int other = e.partner < 0 ? kSeveral : rims.root(edges[e.partner].vertex[0]);
    partner = partner == kUnknown || partner == other ? other : kSeveral;
  }
  std::vector<bool> cut(edges.size(), false);
  for (std::size_t i = 0; i < edges.size(); ++i) {
    if (edges[i].partner < 0) continue;
    const OpenEdge& mate = edges[edges[i].partner];
    const int rim = rims.root(edges[i].vertex[0]), other = rims.root(mate.vertex[0]);
    cut[i] = rim != other && partner_rim[rim] == other && partner_rim[other] == rim &&
             pieces.root(edges[i].face) == pieces.root(mate.face);
  }
  return cut;
}

}  // namespace

std::vector<int> join_doubled_vertices(const VertexArray& vertices, const FaceList& faces,
                                       double tolerance) {
  const auto vertex_count = static_cast<std::size_t>(vertices.rows());
  DisjointSets joined(vertex_count), pieces(faces.corners.size());
  std::vector<OpenEdge> open;
  std::vector<int> candidates;
  for_each_edge(sorted_sides(faces), [&](auto first, auto last) {
    for (auto side = first + 1; side != last; ++side) pieces.unite(first->face, side->face);
    if (last - first != 1) return;
    open.push_back({{}, {first->a, first->b}, first->face});
    candidates.push_back(first->a);
    candidates.push_back(first->b);
  });
  std::sort(candidates.begin(), candidates.end());
  candidates.erase(std::unique(candidates.begin(), candidates.end()), candidates.end());

  if (!open.empty() && tolerance > 0.0) {
    DisjointSets places = group_by_place(vertices, candidates, tolerance);
    std::vector<OpenEdge> edges;
    for (OpenEdge& e : open) {
      // A side without length: its face collapses, and the faces beside it become neighbours.
      const auto& c = faces.corners[e.face];
      const std::array<int, 3> at = {places.root(c[0]), places.root(c[1]), places.root(c[2])};
      if (places.root(e.vertex[0]) == places.root(e.vertex[1]))
        joined.unite(e.vertex[0], e.vertex[1]);
      if (at[0] == at[1] || at[1] == at[2] || at[2] == at[0]) continue;
      if (places.root(e.vertex[0]) > places.root(e.vertex[1]))
        std::swap(e.vertex[0], e.vertex[1]);
      e.place = {places.root(e.vertex[0]), places.root(e.vertex[1])};
      edges.push_back(e);
    }
    std::stable_sort(edges.begin(), edges.end(),
                     [](const OpenEdge& x, const OpenEdge& y) { return x.place < y.place; });
    for (std::size_t i = 0; i + 1 < edges.size(); ++i) {
      const bool pair = same_places(edges[i], edges[i + 1]) &&
                        (i == 0 || !same_places(edges[i - 1], edges[i])) &&
                        (i + 2 == edges.size() || !same_places(edges[i + 1], edges[i + 2]));
      if (!pair) continue;
      edges[i].partner = static_cast<int>(i + 1);
      edges[i + 1].partner = static_cast<int>(i);
    }
    const std::vector<bool> cut = edges_of_cuts(edges, pieces, vertex_count);
    for (std::size_t i = 0; i < edges.size(); ++i)
      if (edges[i].partner >= 0 && !cut[i])
        for (int end = 0; end < 2; ++end)
          joined.unite(edges[i].vertex[end], edges[edges[i].partner].vertex[end]);
  }
  std::vector<int> representative(vertex_count);
  for (std::size_t v = 0; v < vertex_count; ++v)
    representative[v] = joined.root(static_cast<int>(v));
  return representative;
}

}  // namespace meshknit
