#include "meshknit/remesh/patch.h"

namespace meshknit {
namespace {

// Steps along edges: a change is felt this far, and hardly further.
constexpr int radius = 5;

constexpr int rounds = 30;

}  // namespace

void Patch::put(int node) {
  if (node < 0 || has(node)) return;
  if (node >= static_cast<int>(place_.size())) place_.resize(node + 1, -1);
  place_[node] = static_cast<int>(nodes_.size());
  nodes_.push_back(node);
}

void Patch::gather(const std::vector<int>& centre) {
  for (const int node : nodes_) place_[node] = -1;
  nodes_.clear();
  before_.clear();
  for (const int node : centre) put(node);
  std::size_t done = 0;
  for (int k = 0; k < radius; ++k)
    for (const std::size_t end = nodes_.size(); done < end; ++done) {
      const int node = nodes_[done];
      put(graph_.previous(node));
      put(graph_.next(node));
      for (const Side side : {Side::below, Side::above})
        for (const int other : graph_.links(node, side)) put(other);
    }
  for (const int node : nodes_) before_.push_back(points_.point(node));
  find_springs();
}

void Patch::include(const std::vector<int>& added) {
  for (const int node : added) put(node);
  find_springs();
}

// Every edge once: from its lower or earlier node, if that is in the patch, else from the other.
void Patch::find_springs() {
  springs_.clear();
  for (const int node : nodes_) {
    if (graph_.next(node) >= 0) springs_.push_back({node, graph_.next(node), size_.width});
    if (graph_.previous(node) >= 0 && !has(graph_.previous(node)))
      springs_.push_back({graph_.previous(node), node, size_.width});
    for (const int above : graph_.links(node, Side::above))
      springs_.push_back({node, above, size_.height});
    for (const int below : graph_.links(node, Side::below))
      if (!has(below)) springs_.push_back({below, node, size_.height});
  }
}

double Patch::error() const {
  double sum = 0.0;
  for (const Spring& spring : springs_) {
    const double error = points_.error(spring);
    sum += error * error;
  }
  return sum;
}

void Patch::relax() {
  std::vector<int> movable;
  for (const int node : nodes_)
    if (graph_.links(node, Side::below).size() > 0 &&
        graph_.links(node, Side::above).size() > 0)
      movable.push_back(node);
  points_.relax(springs_, movable, rounds);
}

void Patch::restore() {
  for (std::size_t k = 0; k < before_.size(); ++k) points_.move(nodes_[k], before_[k]);
}

}  // namespace meshknit
