#include "meshknit/remesh/geodesic_band.h"

#include <algorithm>
#include <cmath>
#include <functional>

namespace meshknit {
namespace {

using Eigen::Vector2d;
using HalfedgeHandle = TriangleMesh::HalfedgeHandle;

constexpr double pi = 3.14159265358979323846;
constexpr double infinity = std::numeric_limits<double>::infinity();

// Rays that miss a vertex by less than this fraction of an edge still measure it: the error is
// of second order, and no vertex falls between two neighbouring windows.
constexpr double graze = 0.01;

// A vertex with more angle than this around it casts a shadow that straight rays do not reach.
constexpr double angle_excess = 0.01;

// Rays are passed on in the order of their distance. Only those of one step of the way to the limit are
// kept sorted: one heap of all would be an order of magnitude larger, and slower.
constexpr int count_of_steps = 1024;

double cross(const Vector2d& a, const Vector2d& b) { return a.x() * b.y() - a.y() * b.x(); }
Vector2d left_of(const Vector2d& a) { return {-a.y(), a.x()}; }

// Keeps the part of [begin, end] where the linear function with these values at 0 and 1 is not
// negative.
bool clip(double at0, double at1, double& begin, double& end) {
  const double slope = at1 - at0;
  const double f_begin = at0 + begin * slope, f_end = at0 + end * slope;
  if (f_begin < 0.0 && f_end < 0.0) return false;
  if (f_begin < 0.0) begin = std::min(end, -at0 / slope);
  if (f_end < 0.0) end = std::max(begin, -at0 / slope);
  return begin < end;
}

}  // namespace

GeodesicBand::GeodesicBand(const PeelState& state, const KnitLimits& limits)
    : state_(state),
      limits_(limits),
      distance_(state.mesh.n_vertices(), infinity),
      foot_(state.mesh.n_vertices(), 0.0),
      nearest_(state.mesh.n_vertices(), 0),
      cycle_of_edge_(state.mesh.n_edges(), -1),
      place_on_edge_(state.mesh.n_edges(), 0.0),
      apex_(state.mesh.n_halfedges(), Vector2d::Zero()),
      bends_(state.mesh.n_vertices(), 0),
      steps_(count_of_steps) {
  std::vector<double> angle(state.mesh.n_vertices(), 0.0);
  for (const auto h : state.mesh.halfedges()) {
    if (state.mesh.is_boundary(h)) continue;
    const Vector2d c = apex_[h.idx()] = find_apex(h.idx());
    angle[state.from(h.idx())] += std::atan2(c.y(), c.x());
  }
  for (const auto v : state.mesh.vertices()) {
    const double full = state.mesh.is_boundary(v) ? pi : 2.0 * pi;
    bends_[v.idx()] = angle[v.idx()] > full + angle_excess;
  }
}

void GeodesicBand::measure(const std::vector<const Cycle*>& cycles, double limit) {
  for (const int v : reached_) distance_[v] = infinity;
  for (const int e : crossed_) cycle_of_edge_[e] = -1;
  reached_.clear();
  crossed_.clear();
  windows_.clear();
  step_ = -1;
  limit_ = limit;
  const int count = static_cast<int>(cycles.size());
  for (int k = 0; k < count; ++k)
    for (int i = 0; i < cycles[k]->size(); ++i) {
      const int edge = cycles[k]->crossings[i].halfedge >> 1;
      cycle_of_edge_[edge] = k;
      place_on_edge_[edge] = cycles[k]->arc[i];
      crossed_.push_back(edge);
    }
  for (int k = 0; k < count; ++k)
    for (int i = 0; i < cycles[k]->size(); ++i) launch_piece(*cycles[k], k, i);
  for (int k = 0; k < count; ++k)
    for (int i = 0; i < cycles[k]->size(); ++i) launch_corner(*cycles[k], k, i);
  for (step_ = 0; step_ < count_of_steps; ++step_) {
    std::vector<Event>& step = steps_[step_];
    std::make_heap(step.begin(), step.end(), std::greater<>());
    while (!step.empty()) {
      const Event next = step.front();
      std::pop_heap(step.begin(), step.end(), std::greater<>());
      step.pop_back();
      if (next.what >= 0) {
        const Window window = windows_[next.what];
        propagate(window);
      } else if (next.distance <= distance_[-1 - next.what]) {
        launch_vertex(-1 - next.what);
      }
    }
  }
  std::sort(reached_.begin(), reached_.end());
}

Vector2d GeodesicBand::find_apex(int halfedge) const {
  const auto next = state_.mesh.next_halfedge_handle(HalfedgeHandle(halfedge));
  const double l = state_.length(halfedge);
  const double far = state_.length(next.idx());
  const double near = state_.length(state_.mesh.next_halfedge_handle(next).idx());
  const double x = (l * l + near * near - far * far) / (2.0 * l);
  return {x, std::sqrt(std::max(0.0, near * near - x * x))};
}

bool GeodesicBand::open_range(int halfedge, double& begin, double& end) const {
  const bool from_knitted = state_.knitted[state_.from(halfedge)];
  const bool to_knitted = state_.knitted[state_.to(halfedge)];
  const double t = state_.crossing[halfedge >> 1];
  begin = from_knitted ? t : 0.0;
  end = to_knitted ? 1.0 - t : 1.0;
  return (!from_knitted && limits_.may_knit(state_.from(halfedge))) ||
         (!to_knitted && limits_.may_knit(state_.to(halfedge)));
}

void GeodesicBand::push(const Event& event) {
  // What comes of a step is never nearer, but for rounding.
  const int number = std::clamp(static_cast<int>(event.distance / limit_ * count_of_steps),
                                std::max(step_, 0), count_of_steps - 1);
  std::vector<Event>& step = steps_[number];
  step.push_back(event);
  if (number == step_) std::push_heap(step.begin(), step.end(), std::greater<>());
}

void GeodesicBand::improve(int vertex, double distance, double foot, int cycle) {
  if (state_.knitted[vertex] || distance >= distance_[vertex]) return;
  if (distance_[vertex] == infinity) reached_.push_back(vertex);
  distance_[vertex] = distance;
  foot_[vertex] = foot;
  nearest_[vertex] = cycle;
  if (bends_[vertex] && distance < limit_ && limits_.may_knit(vertex))
    push({distance, -1 - vertex});
}

void GeodesicBand::launch_piece(const Cycle& cycle, int number, int piece) {
  const int next = (piece + 1) % cycle.size();
  const EdgeCrossing &here = cycle.crossings[piece], &there = cycle.crossings[next];
  const auto back = state_.mesh.opposite_halfedge_handle(HalfedgeHandle(here.halfedge));
  const auto on = state_.mesh.next_halfedge_handle(back),
             last = state_.mesh.next_halfedge_handle(on);
  const Vector2d w(0.0, 0.0), u(state_.length(back.idx()), 0.0), x = apex(back.idx());
  const Vector2d a = u + here.t * (w - u);
  const Vector2d b = there.halfedge == on.idx() ? Vector2d(u + there.t * (x - u))
                                                : Vector2d(x + there.t * (w - x));
  const int open_end = state_.from(back.idx()), third = state_.to(on.idx());
  for (const auto& [vertex, place] : {std::pair<int, Vector2d>{open_end, w}, {third, x}}) {
    improve(vertex, (place - a).norm(), cycle.arc[piece], number);
    improve(vertex, (place - b).norm(), cycle.arc[next], number);
  }
  const double length = (b - a).norm();
  if (!(length > 0.0)) return;
  const Vector2d along = (b - a) / length, ray = left_of(along);
  for (const auto& [vertex, place] : {std::pair<int, Vector2d>{open_end, w}, {third, x}}) {
    const double beside = (place - a).dot(along);
    if (beside >= 0.0 && beside <= length)
      improve(vertex, (place - a).dot(ray), cycle.arc[piece] + beside, number);
  }
  const Source source{true, a, ray, 0.0, cycle.arc[piece], number};
  const Bounds bounds{a, ray, b, ray};
  emit(back.idx(), w, u, &bounds, source);
  emit(on.idx(), u, x, &bounds, source);
  emit(last.idx(), x, w, &bounds, source);
}

void GeodesicBand::launch_corner(const Cycle& cycle, int number, int corner) {
  const int n = cycle.size(), before = (corner + n - 1) % n, after = (corner + 1) % n;
  const HalfedgeHandle h(cycle.crossings[corner].halfedge);
  const auto back = state_.mesh.opposite_halfedge_handle(h);
  const double l = state_.length(h.idx());
  // Both triangles of the edge, unfolded into the frame of h: the cycle comes from above and
  // goes on below.
  const Vector2d u(0.0, 0.0), w(l, 0.0), above = apex(h.idx());
  const Vector2d below_apex = apex(back.idx()), below(l - below_apex.x(), -below_apex.y());
  const auto place = [&](const EdgeCrossing& c, const Vector2d& third) {
    const int from = state_.from(c.halfedge), to = state_.to(c.halfedge);
    const int at_u = state_.from(h.idx()), at_w = state_.to(h.idx());
    const Vector2d& p = from == at_u ? u : from == at_w ? w : third;
    const Vector2d& q = to == at_u ? u : to == at_w ? w : third;
    return Vector2d(p + c.t * (q - p));
  };
  const Vector2d here(cycle.crossings[corner].t * l, 0.0);
  const Vector2d in = here - place(cycle.crossings[before], above);
  const Vector2d out = place(cycle.crossings[after], below) - here;
  if (!(in.norm() > 0.0) || !(out.norm() > 0.0) || cross(in, out) >= 0.0) return;
  // The cycle turns right: rays fan out from the corner between the two pieces' own.
  const Source source{false, here, Vector2d::Zero(), 0.0, cycle.arc[corner], number};
  const Bounds bounds{here, left_of(in), here, left_of(out)};
  const auto up = state_.mesh.next_halfedge_handle(h);
  emit(up.idx(), w, above, &bounds, source);
  emit(state_.mesh.next_halfedge_handle(up).idx(), above, u, &bounds, source);
  const auto down = state_.mesh.next_halfedge_handle(back);
  emit(down.idx(), u, below, &bounds, source);
  emit(state_.mesh.next_halfedge_handle(down).idx(), below, w, &bounds, source);
}

void GeodesicBand::launch_vertex(int vertex) {
  const double before = distance_[vertex], foot = foot_[vertex];
  const int cycle = nearest_[vertex];
  const Source source{false, Vector2d::Zero(), Vector2d::Zero(), before, foot, cycle};
  for (const auto h : state_.mesh.voh_range(TriangleMesh::VertexHandle(vertex))) {
    improve(state_.to(h.idx()), before + state_.length(h.idx()), foot, cycle);
    if (state_.mesh.is_boundary(h)) continue;
    const Vector2d a(state_.length(h.idx()), 0.0);
    emit(state_.mesh.next_halfedge_handle(h).idx(), a, apex(h.idx()), nullptr, source);
  }
}

void GeodesicBand::propagate(const Window& window) {
  const HalfedgeHandle h(window.halfedge);
  const Vector2d c = apex(h.idx());
  const double l = state_.length(h.idx());
  const Source& source = window.source;
  const Vector2d low(window.begin, 0.0), high(window.end, 0.0);
  const Bounds bounds{low, source.strip ? source.ray : Vector2d(low - source.point), high,
                      source.strip ? source.ray : Vector2d(high - source.point)};
  const auto next = state_.mesh.next_halfedge_handle(h);
  const double left_by = -cross(bounds.low_ray, c - low) / bounds.low_ray.norm();
  const double right_by = cross(bounds.high_ray, c - high) / bounds.high_ray.norm();
  if (left_by >= -graze * l && right_by >= -graze * l) {
    const Vector2d offset = c - source.point;
    if (source.strip)
      improve(state_.to(next.idx()), source.before + offset.dot(source.ray),
              source.foot - cross(source.ray, offset), source.cycle);
    else
      improve(state_.to(next.idx()), source.before + offset.norm(), source.foot, source.cycle);
  }
  emit(next.idx(), {l, 0.0}, c, &bounds, source);
  emit(state_.mesh.next_halfedge_handle(next).idx(), c, {0.0, 0.0}, &bounds, source);
}

// Passes rays on through an edge of the triangle that they are in: `inner` is that triangle's
// half edge, from and to its ends in the plane.
void GeodesicBand::emit(int inner, const Vector2d& from, const Vector2d& to,
                        const Bounds* bounds, const Source& source) {
  const HalfedgeHandle out = state_.mesh.opposite_halfedge_handle(HalfedgeHandle(inner));
  if (state_.mesh.is_boundary(out)) return;
  double begin, end;
  if (!open_range(inner, begin, end)) return;
  if (bounds) {
    const Bounds& b = *bounds;
    if (!clip(-cross(b.low_ray, from - b.low), -cross(b.low_ray, to - b.low), begin, end))
      return;
    if (!clip(cross(b.high_ray, from - b.high), cross(b.high_ray, to - b.high), begin, end))
      return;
  }
  const double l = state_.length(inner);
  const Vector2d ex = (from - to) / l, ey = left_of(ex);
  const auto turned = [&](const Vector2d& v) { return Vector2d(v.dot(ex), v.dot(ey)); };
  Window window{out.idx(), (1.0 - end) * l, (1.0 - begin) * l, source};
  Source& s = window.source;
  s.point = turned(source.point - to);
  double nearest = source.before;
  if (source.strip) {
    s.ray = turned(source.ray);
    if (s.ray.y() <= 1e-9) return;
    const double at_begin = (Vector2d(window.begin, 0.0) - s.point).dot(s.ray);
    const double at_end = (Vector2d(window.end, 0.0) - s.point).dot(s.ray);
    nearest += std::min(at_begin, at_end);
  } else {
    if (s.point.y() >= -1e-9 * l) return;
    const double x = std::clamp(s.point.x(), window.begin, window.end);
    nearest += (Vector2d(x, 0.0) - s.point).norm();
  }
  if (nearest > limit_) return;
  // Rays that are everywhere beaten by the way over an end of the edge lead nowhere new.
  if (distance_[state_.from(out.idx())] + window.end <= nearest) return;
  if (distance_[state_.to(out.idx())] + l - window.begin <= nearest) return;
  windows_.push_back(window);
  push({nearest, static_cast<int>(windows_.size()) - 1});
}

}  // namespace meshknit
