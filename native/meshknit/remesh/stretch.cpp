#include "meshknit/remesh/stretch.h"

#include <algorithm>

namespace meshknit {
namespace {

// Edges over which a lack is summed up, each way.
constexpr int reach = 4;

}  // namespace

int Stretch::after(int node, EdgeKind kind) const {
  return kind == EdgeKind::row ? graph_.next(node) : graph_.links(node, Side::above).front();
}

int Stretch::before(int node, EdgeKind kind) const {
  return kind == EdgeKind::row ? graph_.previous(node)
                               : graph_.links(node, Side::below).front();
}

double Stretch::error(int node, EdgeKind kind) const {
  const int to = after(node, kind);
  if (to < 0) return -1.0;
  return points_.error({node, to, kind == EdgeKind::row ? size_.width : size_.height});
}

double Stretch::lack(int node, EdgeKind kind) const {
  double sum = 0.0;
  for (int k = 0, at = node; k < reach && after(at, kind) >= 0; ++k, at = after(at, kind))
    sum += error(at, kind);
  for (int k = 1, at = before(node, kind); k < reach && at >= 0; ++k, at = before(at, kind))
    sum += error(at, kind);
  return sum;
}

std::vector<StretchedEdge> Stretch::edges(double least_error) const {
  std::vector<StretchedEdge> edges;
  for (int node = 0; node < graph_.size(); ++node)
    for (const EdgeKind kind : {EdgeKind::column, EdgeKind::row}) {
      const double e = error(node, kind);
      if (e > least_error) edges.push_back({node, kind, e});
    }
  std::stable_sort(
      edges.begin(), edges.end(),
      [](const StretchedEdge& a, const StretchedEdge& b) { return a.error > b.error; });
  return edges;
}

}  // namespace meshknit
