#include "meshknit/remesh/sweep_plan.h"

#include <algorithm>
#include <cmath>
#include <limits>

#include "meshknit/remesh/joined_saddles.h"
#include "meshknit/surface/fast_marching.h"

namespace meshknit {
namespace {

constexpr double infinity = std::numeric_limits<double>::infinity();

// The rows of a tube stay this part of a row clear of the saddle at its end: two strands half a row
// from a saddle are a row apart, and the next row just steps over it.
constexpr double clear_of_saddle = 0.5;

// Crossings keep this far from an edge's ends.
constexpr double least_fraction = 0.02;

void name_regions(SweepPlan& plan) {
  const ReebGraph& reeb = plan.reeb;
  plan.region = reeb.arc_of_vertex;
  for (std::size_t e = 0; e < reeb.events.size(); ++e)
    for (const int v : reeb.events[e].vertices)
      plan.region[v] = plan.event_region(static_cast<int>(e));
  for (const ReebArc& arc : reeb.arcs) plan.end_level.push_back(reeb.events[arc.to].time);
  plan.joined.assign(reeb.events.size(), 0);
}

void divide(const PeelState& state, double row_height, SweepPlan& plan) {
  const ReebGraph& reeb = plan.reeb;
  plan.from_saddle.assign(plan.region.size(), infinity);
  plan.saddle_radius = clear_of_saddle * row_height;
  const auto anywhere = [](int) { return true; };
  for (std::size_t e = 0; e < reeb.events.size(); ++e) {
    const ReebEvent& event = reeb.events[e];
    const int number = static_cast<int>(e);
    if (event.is_start() || event.is_end()) {
      // Flat places beside a boundary that share its time are knit by the tube, not left out.
      const int arc = event.is_start() ? event.above.front() : event.below.front();
      for (const int v : event.vertices)
        if (!state.mesh.is_boundary(TriangleMesh::VertexHandle(v))) plan.region[v] = arc;
      continue;
    }
    std::vector<MarchSeed> seeds;
    for (const int v : event.vertices) seeds.push_back({v, 0.0});
    std::vector<double>& distance = plan.from_saddle;
    march(state.mesh, state.edge_length, seeds, (clear_of_saddle + 1.0) * row_height, anywhere,
          distance);
    const auto is_one_of = [&](const std::vector<int>& arcs, int v) {
      return std::find(arcs.begin(), arcs.end(), reeb.arc_of_vertex[v]) != arcs.end();
    };
    // Spread from the saddle, so that what lies near only through the air is left alone.
    std::vector<int> near = event.vertices;
    std::vector<char> seen(plan.region.size(), 0);
    for (const int v : near) seen[v] = 1;
    for (std::size_t k = 0; k < near.size(); ++k)
      for (const auto w : state.mesh.vv_range(TriangleMesh::VertexHandle(near[k]))) {
        const int v = w.idx();
        if (seen[v] || !(distance[v] < plan.saddle_radius)) continue;
        if (plan.region[v] != plan.event_region(number) && !is_one_of(event.above, v) &&
            !is_one_of(event.below, v))
          continue;
        seen[v] = 1;
        near.push_back(v);
        plan.region[v] = plan.event_region(number);
      }
  }
}

void measure_to_end(const PeelState& state, double row_height, SweepPlan& plan) {
  std::vector<std::vector<MarchSeed>> seeds(plan.reeb.arcs.size());
  const int arcs = static_cast<int>(plan.reeb.arcs.size());
  for (const auto f : state.mesh.faces()) {
    int c[3], k = 0;
    for (const auto v : state.mesh.fv_range(f)) c[k++] = v.idx();
    for (const int inner : c) {
      const int arc = plan.region[inner];
      if (arc >= arcs) continue;
      const double end = plan.end_level[arc];
      const auto beyond = [&](int v) {
        return plan.region[v] != arc &&
               (state.time[v] >= end ||
                plan.region[v] == plan.event_region(plan.reeb.arcs[arc].to));
      };
      std::vector<Eigen::Vector3d> curve;  // where the end curve crosses this triangle
      for (const int u : c)
        for (const int w : c)
          if (!beyond(u) && beyond(w)) {
            const bool rim =
                state.mesh.is_boundary(TriangleMesh::VertexHandle(w)) && plan.region[w] >= arcs;
            const double t = rim ? 1.0 : plan.end_fraction(state, u, w);
            curve.push_back(state.point(u) + t * (state.point(w) - state.point(u)));
          }
      if (curve.empty()) continue;
      seeds[arc].push_back(
          {inner, distance_to_segment(state.point(inner), curve.front(), curve.back())});
    }
  }
  plan.to_end.assign(plan.region.size(), infinity);
  for (int arc = 0; arc < arcs; ++arc)
    march(
        state.mesh, state.edge_length, seeds[arc], planned_rows * row_height,
        [&](int v) { return plan.region[v] == arc; }, plan.to_end);
}

}  // namespace

double SweepPlan::end_fraction(const PeelState& state, int u, int w) const {
  const int arcs = static_cast<int>(reeb.arcs.size());
  double fraction = 1.0;
  const bool at_event = region[w] >= arcs;
  const double d_u = from_saddle[u], d_w = from_saddle[w];
  if (!at_event || (joined[region[w] - arcs] != 0 && !(d_w < saddle_radius))) {
    const double level = region[u] < arcs ? end_level[region[u]]
                         : at_event       ? state.time[w]
                                          : reeb.events[reeb.arcs[region[w]].from].time;
    if (state.time[u] < level && level < state.time[w])
      fraction = (level - state.time[u]) / (state.time[w] - state.time[u]);
  } else if (!reeb.events[region[w] - arcs].is_end()) {
    fraction = std::isfinite(d_u) && d_u > saddle_radius && d_w < saddle_radius
                   ? (d_u - saddle_radius) / (d_u - d_w)
                   : 0.5;
  }
  return std::clamp(fraction, least_fraction, 1.0);
}

SweepPlan plan_sweep(const PeelState& state, double row_height, const std::vector<int>& apart,
                     RunContext* run) {
  SweepPlan plan;
  plan.reeb = reeb_graph(state.mesh, state.time, run);
  report(run, 0.0);
  name_regions(plan);
  join_near_saddles(state, row_height, apart, plan);
  divide(state, row_height, plan);
  report(run, 0.0);
  measure_to_end(state, row_height, plan);
  report(run, 0.0);
  plan.vertices_of_region.resize(plan.regions());
  for (std::size_t v = 0; v < plan.region.size(); ++v)
    plan.vertices_of_region[plan.region[v]].push_back(static_cast<int>(v));
  return plan;
}

}  // namespace meshknit
