#include "meshknit/remesh/tube_end.h"

#include <algorithm>
#include <cmath>

namespace meshknit {
namespace {

// Rows over which the rest is shared out, and from which on the end's distance leads.
constexpr double shared_rows = 10.0;
constexpr double near_rows = 3.5;

// Stands for distances that are not known, mm.
constexpr double far_away = 1e9;

}  // namespace

RestOfTube rest_of_tube(const PeelState& state, const SweepPlan& plan, int arc,
                        const Cycle& active, double row_height) {
  const int n = active.size();
  RestOfTube rest;
  rest.least = far_away;
  const auto to_end = [&](int v) { return std::min(plan.to_end[v], far_away); };
  for (const EdgeCrossing& c : active.crossings) {
    const int u = state.from(c.halfedge), w = state.to(c.halfedge);
    const double at_w = plan.region[w] == arc ? to_end(w) : 0.0;  // else it lies beyond the end
    // A vertex of the junction below has no distance of its own.
    const double at_u = plan.region[u] == arc ? to_end(u) : at_w + state.length(c.halfedge);
    rest.at_crossing.push_back(at_u + c.t * (at_w - at_u));
  }
  for (int i = 0; i < n; ++i) {
    rest.least = std::min(rest.least, rest.at_crossing[i]);
    rest.most = std::max(rest.most, rest.at_crossing[i]);
    rest.mean += 0.5 * (rest.at_crossing[i] + rest.at_crossing[(i + 1) % n]) *
                 (active.arc[i + 1] - active.arc[i]) / active.length();
  }
  rest.height = row_height;
  rest.near = rest.least <= near_rows * row_height;
  const bool far = rest.most > 0.5 * far_away;
  if (!rest.near && far) return rest;
  rest.rows = std::max(
      1, static_cast<int>(std::lround((rest.near ? rest.least : rest.mean) / row_height)));
  if (rest.rows > shared_rows) return rest;
  rest.height = rest.mean / rest.rows;
  return rest;
}

}  // namespace meshknit
