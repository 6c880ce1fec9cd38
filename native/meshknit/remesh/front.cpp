#include "meshknit/remesh/front.h"

#include <algorithm>
#include <cmath>

namespace meshknit {

double forward(double a, double b, double length) {
  double d = b - a;
  // Nearly always both places lie on the first lap.
  if (d < 0.0) d += length;
  if (d >= length) d -= length;
  if (d >= 0.0 && d < length) return d;
  d = std::fmod(d, length);
  return d < 0.0 ? d + length : d;
}

double around(double a, double b, double length) {
  const double d = forward(a, b, length);
  return d < 0.5 * length ? d : d - length;
}

CyclePoint Cycle::at(double distance) const {
  const double s = forward(0.0, distance, length());
  const auto after = std::upper_bound(arc.begin() + 1, arc.end() - 1, s);
  const int piece = static_cast<int>(after - arc.begin()) - 1;
  const double long_piece = arc[piece + 1] - arc[piece];
  return {piece, long_piece > 0.0 ? std::clamp((s - arc[piece]) / long_piece, 0.0, 1.0) : 0.0};
}

Eigen::Vector3d Cycle::position(const CyclePoint& p) const {
  return points[p.piece] + p.along * (points[(p.piece + 1) % size()] - points[p.piece]);
}

double Cycle::value(const CyclePoint& p, const std::vector<double>& at_crossings) const {
  const double a = at_crossings[p.piece], b = at_crossings[(p.piece + 1) % size()];
  return a + p.along * (b - a);
}

void measure_cycle(const PeelState& state, Cycle& cycle) {
  const int n = cycle.size();
  cycle.points.resize(n);
  cycle.arc.assign(n + 1, 0.0);
  for (int i = 0; i < n; ++i) {
    const EdgeCrossing& c = cycle.crossings[i];
    const Eigen::Vector3d& a = state.point(state.from(c.halfedge));
    cycle.points[i] = a + c.t * (state.point(state.to(c.halfedge)) - a);
  }
  for (int i = 0; i < n; ++i)
    cycle.arc[i + 1] = cycle.arc[i] + (cycle.points[(i + 1) % n] - cycle.points[i]).norm();
}

}  // namespace meshknit
