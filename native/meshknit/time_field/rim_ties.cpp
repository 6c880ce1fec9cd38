#include "meshknit/time_field/rim_ties.h"

#include <algorithm>
#include <limits>

namespace meshknit {
namespace {

// Part of the way to the nearest other time among the neighbours.
constexpr double part = 1e-3;

}  // namespace

void part_from_rims(const TriangleMesh& mesh, std::vector<double>& time) {
  constexpr double infinity = std::numeric_limits<double>::infinity();
  const std::vector<double> before = time;
  for (const auto v : mesh.vertices()) {
    if (mesh.is_boundary(v)) continue;
    const double here = before[v.idx()];
    bool beside_rim = false;
    double later = infinity, earlier = -infinity;
    for (const auto w : mesh.vv_range(v)) {
      const double there = before[w.idx()];
      beside_rim = beside_rim || (mesh.is_boundary(w) && there == here);
      if (there > here) later = std::min(later, there);
      if (there < here) earlier = std::max(earlier, there);
    }
    if (!beside_rim) continue;
    if (later < infinity && earlier == -infinity) time[v.idx()] += part * (later - here);
    if (earlier > -infinity && later == infinity) time[v.idx()] += part * (earlier - here);
  }
}

}  // namespace meshknit
