#include "meshknit/remesh/peeling.h"

#include <algorithm>
#include <cmath>
#include <limits>

#include "meshknit/core/error.h"
#include "meshknit/remesh/distance_to_end.h"
#include "meshknit/remesh/finish_graph.h"
#include "meshknit/remesh/relaxation.h"
#include "meshknit/remesh/sampling.h"
#include "meshknit/remesh/start_cycle.h"
#include "meshknit/surface/refine.h"
#include "meshknit/surface/reorder.h"

namespace meshknit {
namespace {

// Longest edge of the fine mesh, as a fraction of the smaller stitch dimension: rows bend no
// more sharply than that.
constexpr double fine_edge = 0.8;

// Shortest short row: three nodes are 2 l_r long.
constexpr int fewest_in_short_row = 3;

// Shorter runs than this wait until they are two rows late: a sixth of a narrow row, a dozen
// stitches of a middling one, a tenth of a wide one.
int worthwhile_run(int count) { return std::min(count / 6, std::max(12, count / 10)); }

// How far beyond its last node a short row's end reaches, as a fraction of the way to the next
// node.
constexpr double beyond_end = 0.1;

std::vector<double> times_of(const PeelState& state, const Cycle& cycle) {
  std::vector<double> times;
  for (const EdgeCrossing& c : cycle.crossings) {
    const double u = state.time[state.from(c.halfedge)], w = state.time[state.to(c.halfedge)];
    times.push_back(u + c.t * (w - u));
  }
  return times;
}

// The triangle that a cycle's piece after this crossing lies in: the one right of the half
// edge.
int face_of_piece(const TriangleMesh& mesh, const EdgeCrossing& crossing) {
  return mesh
      .face_handle(
          mesh.opposite_halfedge_handle(TriangleMesh::HalfedgeHandle(crossing.halfedge)))
      .idx();
}

int partner_of(const std::vector<Link>& links, int next) {
  for (const Link& link : links)
    if (link[1] == next) return link[0];
  throw BrokenPromise("a node of the next row has no column");
}

}  // namespace

Peeling::Peeling(const Surface& surface, const std::vector<double>& time,
                 const RemeshOptions& options)
    : options_(options), row_height_(2.0 * options.stitch_height) {
  graph_.stitch_width = options.stitch_width;
  graph_.stitch_height = options.stitch_height;
  RefinedMesh fine =
      refine_mesh(surface.mesh, time, fine_edge * std::min(options.stitch_width, row_height_));
  const std::vector<int> number = reorder_by_value(fine);
  state_.mesh = std::move(fine.mesh);
  state_.time = std::move(fine.value);
  state_.knitted.assign(state_.mesh.n_vertices(), 0);
  state_.crossing.assign(state_.mesh.n_edges(), 0.5);
  state_.edge_length.resize(state_.mesh.n_edges());
  for (const auto e : state_.mesh.edges())
    state_.edge_length[e.idx()] = state_.mesh.calc_edge_length(e);
  piece_of_edge_.assign(state_.mesh.n_edges(), -1);
  start(surface, number[surface.boundaries[0].vertices[0]],
        number[surface.boundaries[1].vertices[0]]);
}

void Peeling::start(const Surface& surface, int a, int b) {
  const bool a_first = state_.time[a] < state_.time[b];
  const std::vector<char> first = mark_boundary(state_.mesh, a_first ? a : b);
  last_ = mark_boundary(state_.mesh, a_first ? b : a);
  band_ = std::make_unique<GeodesicBand>(state_);
  slicer_ = std::make_unique<Slicer>(state_, last_);
  trimmer_ = std::make_unique<Trimmer>(state_, last_);

  std::vector<double> to_end =
      distance_to(state_, last_, (RowHeights::shared_rows + 1) * row_height_);
  heights_ = std::make_unique<RowHeights>(std::move(to_end), row_height_);

  state_.knitted.assign(first.begin(), first.end());
  active_.cycle = cycle_beside(state_, first);
  NextCycle row;
  row.cycle = active_.cycle;
  for (int i = 0; i < row.cycle.size(); ++i)
    row.time.push_back(state_.time[state_.from(row.cycle.crossings[i].halfedge)]);
  // The boundary itself is measured: the cycle beside it zigzags a little.
  const double wanted = surface.boundaries[a_first ? 0 : 1].length / options_.stitch_width;
  const int count = std::max(3, static_cast<int>(std::lround(wanted)));
  const double length = row.cycle.length();
  Row first_row;
  for (int j = 0; j < count; ++j) {
    first_row.place.push_back(j * length / count);
    first_row.time.push_back(row.cycle.value(row.cycle.at(first_row.place.back()), row.time));
  }
  first_row.single.assign(count, 0);
  const std::vector<int> node_of = add_row(row, first_row);
  replace_active(row, first_row, node_of, row.cycle);
}

double Peeling::progress() const {
  return static_cast<double>(knitted_) / static_cast<double>(state_.mesh.n_vertices());
}

void Peeling::peel_row() {
  const RowHeights::Next height = heights_->next(state_, active_.cycle);
  const double infinity = std::numeric_limits<double>::infinity();
  band_->measure(active_.cycle, height.last ? infinity : 1.2 * height.height);
  const double level = height.last ? infinity : height.height;
  std::vector<NextCycle> cycles = slicer_->slice(*band_, active_.cycle, level);
  if (cycles.empty()) throw BrokenPromise("slicing found no next cycle");
  const NextCycle& next = cycles.front();

  Row row;
  const std::vector<double> images = images_on_next(active_, next);
  row.place = sample_next_row(active_, next, images, options_.stitch_width);
  for (const double place : row.place)
    row.time.push_back(next.cycle.value(next.cycle.at(place), next.time));
  if (!height.last) row.runs = accept(next, row);
  keep_turns_apart(row, next, images);

  Cycle cycle = trimmer_->trim(*band_, active_.cycle, next.cycle, level, regions(next, row));
  if (!row.runs.empty() && trimmer_->newly_knitted() == 0) {
    row.runs.clear();
    link(next, images, row);
    cycle = trimmer_->trim(*band_, active_.cycle, next.cycle, level, {});
  }
  knitted_ += trimmer_->newly_knitted();
  const std::vector<int> node_of = add_row(next, row);
  replace_active(next, row, node_of, std::move(cycle));
  done_ = height.last;
}

KnitGraph Peeling::take_graph(const std::function<void(double)>& progress) {
  relax_nodes(state_.mesh, state_.time, face_of_node_, graph_, progress);
  finish_graph(state_.mesh, face_of_node_, graph_);
  return std::move(graph_);
}

double Peeling::foot_of(const NextCycle& next, double place) const {
  const CyclePoint p = next.cycle.at(place);
  const double a = next.foot[p.piece], b = next.foot[(p.piece + 1) % next.cycle.size()];
  return a + p.along * around(a, b, active_.cycle.length());
}

std::vector<NodeRun> Peeling::accept(const NextCycle& next, const Row& row) const {
  const Cycle& active = active_.cycle;
  const std::vector<double> active_times = times_of(state_, active);
  std::vector<double> gains;
  for (std::size_t j = 0; j < row.place.size(); ++j) {
    const CyclePoint below = active.at(foot_of(next, row.place[j]));
    gains.push_back(row.time[j] - active.value(below, active_times));
  }
  return accept_by_time(row.time, gains,
                        *std::max_element(active_times.begin(), active_times.end()),
                        fewest_in_short_row, worthwhile_run(static_cast<int>(gains.size())));
}

void Peeling::link(const NextCycle& next, const std::vector<double>& images, Row& row) const {
  const int count = static_cast<int>(row.place.size());
  row.single.assign(count, 0);
  for (const NodeRun& run : row.runs) row.single[run.first] = row.single[run.last] = 1;
  LinkProblem problem;
  for (const ActiveNode& node : active_.nodes) {
    problem.active.push_back(node.place);
    problem.active_single.push_back(node.single);
    problem.active_shaped.push_back(node.shaped);
  }
  problem.image = images;
  problem.active_length = active_.cycle.length();
  problem.next = row.place;
  for (const double place : row.place) {
    problem.foot.push_back(foot_of(next, place));
    problem.gap.push_back(next.cycle.value(next.cycle.at(place), next.gap));
  }
  problem.next_single = row.single;
  problem.next_length = next.cycle.length();
  problem.row_height = row_height_;
  row.links = link_rows(problem);
}

// Links the row. A short row must not end right above the end of another: the tucks of both
// turns would pile up on one needle. Runs are shortened until none does.
void Peeling::keep_turns_apart(Row& row, const NextCycle& next,
                               const std::vector<double>& images) const {
  const int count = static_cast<int>(row.place.size());
  for (;;) {
    link(next, images, row);
    if (row.links.empty()) {
      if (row.runs.empty()) throw BrokenPromise("linking found no columns between two rows");
      row.runs.clear();
      continue;
    }
    bool changed = false;
    std::vector<NodeRun> runs;
    for (NodeRun run : row.runs) {
      const int size = run.size(count);
      const bool first_on_end = active_.nodes[partner_of(row.links, run.first)].row_end;
      const bool last_on_end = active_.nodes[partner_of(row.links, run.last)].row_end;
      changed = changed || first_on_end || last_on_end;
      if (size - first_on_end - last_on_end < fewest_in_short_row) continue;
      if (first_on_end) run.first = (run.first + 1) % count;
      if (last_on_end) run.last = (run.last + count - 1) % count;
      runs.push_back(run);
    }
    if (!changed) return;
    row.runs = runs;
  }
}

std::vector<TrimRegion> Peeling::regions(const NextCycle& next, const Row& row) const {
  const int count = static_cast<int>(row.place.size());
  const int active_count = static_cast<int>(active_.nodes.size());
  const double length = active_.cycle.length(), spacing = next.cycle.length() / count;
  const auto foot_at = [&](double place) { return forward(0.0, foot_of(next, place), length); };
  std::vector<TrimRegion> regions;
  for (const NodeRun& run : row.runs) {
    const int a = partner_of(row.links, run.first), b = partner_of(row.links, run.last);
    const double before = active_.nodes[(a + active_count - 1) % active_count].place;
    const double after = active_.nodes[(b + 1) % active_count].place;
    TrimRegion region;
    region.begin_below = before + beyond_end * forward(before, active_.nodes[a].place, length);
    region.begin_above = foot_at(row.place[run.first] - beyond_end * spacing);
    region.end_below = after - beyond_end * forward(active_.nodes[b].place, after, length);
    region.end_above = foot_at(row.place[run.last] + beyond_end * spacing);
    regions.push_back(region);
  }
  return regions;
}

// Adds the accepted nodes of a row, their row edges and their columns. Returns graph nodes, -1
// for discarded ones.
std::vector<int> Peeling::add_row(const NextCycle& next, const Row& row) {
  const int count = static_cast<int>(row.place.size());
  std::vector<int> node_of(count, -1);
  const auto add = [&](const NodeRun& run, bool closed) {
    KnitRow added;
    added.closed = closed;
    const int size = run.size(count);
    for (int k = 0; k < size; ++k) {
      const int j = (run.first + k) % count;
      node_of[j] = static_cast<int>(graph_.nodes.size());
      const CyclePoint p = next.cycle.at(row.place[j]);
      graph_.nodes.push_back({next.cycle.position(p), row.time[j]});
      face_of_node_.push_back(face_of_piece(state_.mesh, next.cycle.crossings[p.piece]));
      added.nodes.push_back(node_of[j]);
    }
    graph_.rows.push_back(std::move(added));
  };
  if (row.runs.empty()) add({0, count - 1}, true);
  for (const NodeRun& run : row.runs) add(run, false);
  for (const Link& l : row.links)
    if (node_of[l[1]] >= 0) graph_.columns.push_back({active_.nodes[l[0]].node, node_of[l[1]]});
  return node_of;
}

ActiveNode Peeling::active_node(const NextCycle& next, double place, int node) const {
  const CyclePoint p = next.cycle.at(place);
  ActiveNode added;
  added.node = node;
  added.halfedge = next.cycle.crossings[p.piece].halfedge;
  added.next_halfedge = next.cycle.crossings[(p.piece + 1) % next.cycle.size()].halfedge;
  added.along = p.along;
  added.position = next.cycle.position(p);
  return added;
}

void Peeling::replace_active(const NextCycle& next, const Row& row,
                             const std::vector<int>& node_of, Cycle cycle) {
  const int count = static_cast<int>(row.place.size());
  const int below_count = static_cast<int>(active_.nodes.size());
  std::vector<int> up(below_count, 0), down(count, 0);
  for (const Link& l : row.links) {
    ++up[l[0]];
    ++down[l[1]];
  }
  std::vector<char> child_of_increase(row.place.size(), 0);
  for (const Link& l : row.links) child_of_increase[l[1]] |= up[l[0]] > 1;
  const auto above = [&](int j) {
    ActiveNode node = active_node(next, row.place[j], node_of[j]);
    node.shaped = down[j] > 1 || child_of_increase[j];
    node.single = node.row_end = row.single[j];
    return node;
  };

  std::vector<ActiveNode> nodes;
  if (row.runs.empty()) {
    for (int j = 0; j < count; ++j) nodes.push_back(above(j));
  } else {
    std::vector<int> run_at(below_count, -1);  // run that begins over this active node
    std::vector<char> covered(active_.nodes.size(), 0);
    for (std::size_t r = 0; r < row.runs.size(); ++r) {
      const int a = partner_of(row.links, row.runs[r].first);
      const int b = partner_of(row.links, row.runs[r].last);
      run_at[a] = static_cast<int>(r);
      for (int i = a;; i = (i + 1) % below_count) {
        covered[i] = 1;
        if (i == b) break;
      }
      active_.nodes[(a + below_count - 1) % below_count].single = true;
      active_.nodes[(b + 1) % below_count].single = true;
    }
    for (int i = 0; i < below_count; ++i) {
      if (!covered[i]) nodes.push_back(active_.nodes[i]);
      if (run_at[i] < 0) continue;
      const NodeRun& run = row.runs[run_at[i]];
      for (int k = 0; k < run.size(count); ++k) nodes.push_back(above((run.first + k) % count));
    }
  }
  active_.nodes = std::move(nodes);
  active_.cycle = std::move(cycle);
  place_nodes(active_, piece_of_edge_);
}

}  // namespace meshknit
