#include "meshknit/time_field/reeb_graph.h"

#include <algorithm>

#include "meshknit/surface/level_walk.h"
#include "meshknit/time_field/critical_spots.h"

namespace meshknit {
namespace {

using HalfedgeHandle = TriangleMesh::HalfedgeHandle;
using VertexHandle = TriangleMesh::VertexHandle;

// Neighbouring vertices with one time, boundaries filled.
struct Spot : TimeSpot {
  double time = 0.0;
  bool has_boundary = false;
  int index() const { return characteristic - sign_changes / 2; }
};

class Sweep {
 public:
  Sweep(const TriangleMesh& mesh, const std::vector<double>& time)
      : mesh_(mesh),
        time_(time),
        arc_of_edge_(mesh.n_edges(), -1),
        walked_(mesh.n_edges(), 0),
        passed_(mesh.n_vertices(), 0) {
    graph_.arc_of_vertex.assign(mesh.n_vertices(), -1);
  }

  ReebGraph run(RunContext* run) {
    std::vector<Spot> spots = find_spots(run);
    for (std::size_t k = 0; k < spots.size(); ++k) {
      if (k % 4096 == 0) report(run, 0.0);
      pass(spots[k]);
    }
    return std::move(graph_);
  }

 private:
  std::vector<Spot> find_spots(RunContext* run) const {
    TimeSpots found = spots_of_mesh(mesh_, time_, run);
    std::vector<Spot> spots;
    for (TimeSpot& spot : found.spots) {
      const double time = time_[spot.vertices.front()];
      spots.push_back({std::move(spot), time});
    }
    fill_boundaries(found.spot_of, spots);
    report(run, 0.0);
    std::stable_sort(spots.begin(), spots.end(),
                     [](const Spot& a, const Spot& b) { return a.time < b.time; });
    return spots;
  }

  void fill_boundaries(const std::vector<int>& spot_of, std::vector<Spot>& spots) const {
    std::vector<char> seen(mesh_.n_halfedges(), 0);
    for (const auto h : mesh_.halfedges()) {
      if (!mesh_.is_boundary(h) || seen[h.idx()]) continue;
      Spot& spot = spots[spot_of[mesh_.from_vertex_handle(h).idx()]];
      spot.has_boundary = true;
      ++spot.characteristic;
      for (HalfedgeHandle g = h; !seen[g.idx()]; g = mesh_.next_halfedge_handle(g))
        seen[g.idx()] = 1;
    }
  }

  void pass(Spot& spot) {
    std::vector<int> below, up;  // arcs; half edges
    for (const int v : spot.vertices) {
      passed_[v] = 1;
      for (const auto h : mesh_.voh_range(VertexHandle(v))) {
        const double there = time_[mesh_.to_vertex_handle(h).idx()];
        if (there < spot.time) below.push_back(arc_of_edge_[h.idx() >> 1]);
        if (there > spot.time) up.push_back(h.idx());
      }
    }
    std::sort(below.begin(), below.end());
    below.erase(std::unique(below.begin(), below.end()), below.end());
    const bool one_vertex = spot.vertices.size() == 1 && !spot.has_boundary;
    if (one_vertex && spot.index() == 0 && below.size() == 1) {
      go_on(spot, below.front(), up);
      return;
    }
    const std::vector<std::vector<int>> cycles = cycles_above(up);
    if (below.size() == 1 && cycles.size() == 1 && spot.index() == 0)
      go_on(spot, below.front(), up);
    else
      add_event(spot, below, cycles);
  }

  void go_on(const Spot& spot, int arc, const std::vector<int>& up) {
    for (const int h : up) arc_of_edge_[h >> 1] = arc;
    for (const int v : spot.vertices) graph_.arc_of_vertex[v] = arc;
  }

  void add_event(Spot& spot, const std::vector<int>& below,
                 const std::vector<std::vector<int>>& cycles) {
    const int number = static_cast<int>(graph_.events.size());
    ReebEvent event;
    event.time = spot.time;
    event.vertices = std::move(spot.vertices);
    event.has_boundary = spot.has_boundary;
    event.index = spot.index();
    event.below = below;
    for (const int arc : below) graph_.arcs[arc].to = number;
    for (const std::vector<int>& cycle : cycles) {
      const int arc = static_cast<int>(graph_.arcs.size());
      graph_.arcs.push_back({number, -1});
      event.above.push_back(arc);
      for (const int edge : cycle) arc_of_edge_[edge] = arc;
    }
    graph_.events.push_back(std::move(event));
  }

  // The edges of each level cycle just above a spot.
  std::vector<std::vector<int>> cycles_above(const std::vector<int>& up) {
    const auto passed = [&](int v) { return passed_[v] != 0; };
    std::vector<std::vector<int>> cycles;
    for (const int first : up) {
      if (walked_[first >> 1]) continue;
      cycles.emplace_back();
      for (int h = first; !walked_[h >> 1]; h = next_crossing(mesh_, h, passed)) {
        walked_[h >> 1] = 1;
        cycles.back().push_back(h >> 1);
      }
    }
    for (const auto& cycle : cycles)
      for (const int edge : cycle) walked_[edge] = 0;
    return cycles;
  }

  const TriangleMesh& mesh_;
  const std::vector<double>& time_;
  std::vector<int> arc_of_edge_;  // of the edges that the level set crosses
  std::vector<char> walked_;      // per edge
  std::vector<char> passed_;      // per vertex
  ReebGraph graph_;
};

}  // namespace

ReebGraph reeb_graph(const TriangleMesh& mesh, const std::vector<double>& time,
                     RunContext* run) {
  return Sweep(mesh, time).run(run);
}

}  // namespace meshknit
