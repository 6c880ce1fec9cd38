#include "meshknit/remesh/peeling.h"

#include <algorithm>
#include <cmath>

#include "meshknit/core/error.h"
#include "meshknit/remesh/even_edges.h"
#include "meshknit/remesh/finish_graph.h"
#include "meshknit/remesh/junction.h"
#include "meshknit/remesh/start_cycle.h"
#include "meshknit/surface/wording.h"

namespace meshknit {

Peeling::Peeling(const Surface& surface, const std::vector<double>& time,
                 const RemeshOptions& options, const std::vector<int>& apart, RunContext* run)
    : peel_(surface, time, options, apart, run), last_row_(peel_.plan.reeb.arcs.size()) {
  for (const ReebEvent& event : peel_.plan.reeb.events) {
    const bool rim = event.below.empty() != event.above.empty();
    const bool one = event.below.size() + event.above.size() == 1 && event.has_boundary;
    if (!rim || one) continue;
    Problem problem;
    problem.code = "false-extremum";
    problem.message = "Near " + place_text(peel_.state.point(event.vertices.front())) +
                      " the knitting time begins or ends without an opening of its own.";
    problem.remedy = "Make an opening there, or smooth the time.";
    problem.elements.faces = peel_.faces_near(event.vertices.front());
    throw NotKnittable({problem});
  }
}

double Peeling::progress() const {
  return static_cast<double>(peel_.knitted) /
         static_cast<double>(peel_.state.mesh.n_vertices());
}

void Peeling::step() {
  if (tubes_.empty()) {
    begin_event();
  } else if (!tubes_.front().peel_row()) {
    last_row_[tubes_.front().arc()] = tubes_.front().take_active();
    tubes_.pop_front();
    if (!tubes_.empty()) tubes_.front().resume();
  }
  done_ = tubes_.empty() && event_ == static_cast<int>(peel_.plan.reeb.events.size());
}

void Peeling::begin_event() {
  const int number = event_++;
  const ReebEvent& event = peel_.plan.reeb.events[number];
  if (event.is_end()) return;
  if (event.is_start()) {
    start(event);
    return;
  }
  std::vector<ActiveCycle> below;
  for (const int arc : event.below) below.push_back(std::move(last_row_[arc]));
  std::vector<ActiveCycle> rows = knit_junction(peel_, number, below);
  for (std::size_t k = 0; k < event.above.size(); ++k)
    begin_tube(event.above[k], std::move(rows[k]));
}

void Peeling::start(const ReebEvent& event) {
  PeelState& state = peel_.state;
  std::vector<char> rim(state.mesh.n_vertices(), 0);
  double around_rim = 0.0;
  for (const int v : event.vertices) {
    const TriangleMesh::VertexHandle vertex(v);
    if (!state.mesh.is_boundary(vertex)) continue;
    rim[v] = state.knitted[v] = 1;
    ++peel_.knitted;
    around_rim += state.length(state.mesh.halfedge_handle(vertex).idx());
  }
  NextCycle next;
  next.cycle = cycle_beside(state, rim);
  for (const EdgeCrossing& c : next.cycle.crossings)
    next.time.push_back(state.time[state.from(c.halfedge)]);
  // The boundary itself is measured: the cycle beside it zigzags a little.
  const int arc = event.above.front();
  const int count =
      std::max(fewest_nodes(arc),
               static_cast<int>(std::lround(around_rim / peel_.options.stitch_width)));
  const double length = next.cycle.length();
  NextRow row;
  for (int j = 0; j < count; ++j) {
    row.place.push_back(j * length / count);
    row.time.push_back(event.time);
  }
  const std::vector<int> node_of = peel_.builder.add_rows(next, row);
  ActiveCycle active;
  active.cycle = next.cycle;
  for (int j = 0; j < count; ++j)
    active.nodes.push_back(active_node(next, row.place[j], node_of[j]));
  place_nodes(active, peel_.piece_of_edge);
  begin_tube(arc, std::move(active));
}

int Peeling::fewest_nodes(int arc) const {
  const ReebGraph& reeb = peel_.plan.reeb;
  // A tube that splits brings enough stitches for both.
  return fewest_round *
         std::max(1, static_cast<int>(reeb.events[reeb.arcs[arc].to].above.size()));
}

void Peeling::begin_tube(int arc, ActiveCycle active) {
  tubes_.emplace_back(peel_, arc, std::move(active), fewest_nodes(arc));
  if (tubes_.size() == 1) tubes_.front().resume();
}

Problems Peeling::warnings() const {
  constexpr double dozen = 12.0;
  double area = 0.0;
  for (const auto f : peel_.state.mesh.faces()) area += peel_.state.mesh.calc_face_area(f);
  const double nodes_a_vertex = area / static_cast<double>(peel_.state.mesh.n_vertices()) /
                                (peel_.options.stitch_width * peel_.row_height);
  Problems problems;
  for (const Trimmer::Pocket& pocket : peel_.left_out) {
    const double nodes = pocket.vertices * nodes_a_vertex;
    if (nodes < dozen) continue;
    Problem problem;
    problem.code = "part-left-out";
    problem.severity = Severity::warning;
    problem.message = "Near " + place_text(peel_.state.point(pocket.vertex)) +
                      " a part of about " + std::to_string(std::lround(2.0 * nodes)) +
                      " stitches is too thin or too steep for rows of this gauge; the fabric "
                      "goes straight over it.";
    problem.remedy =
        "Make an opening at its tip with a time of its own, make it wider or shorter, or take "
        "finer stitches.";
    problem.elements.faces = peel_.faces_near(pocket.vertex);
    problems.push_back(problem);
  }
  return problems;
}

KnitGraph Peeling::take_graph(const std::function<void(double)>& progress) {
  KnitGraph& graph = peel_.builder.graph();
  std::vector<int>& faces = peel_.builder.faces();
  if (peel_.options.relax)
    even_edges(peel_.state.mesh, peel_.state.time, faces, graph, progress);
  finish_graph(peel_.state.mesh, faces, graph);
  return std::move(graph);
}

}  // namespace meshknit
