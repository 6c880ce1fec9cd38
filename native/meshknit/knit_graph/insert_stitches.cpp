#include "meshknit/knit_graph/insert_stitches.h"

namespace meshknit {
namespace {

using Links = EditableGraph::Links;

// A column to this side that neither is nor has an increase or decrease.
bool is_one_to_one(const EditableGraph& graph, int node, Side side) {
  return graph.links(node, side).size() == 1 &&
         graph.links(graph.links(node, side).front(), opposite(side)).size() == 1;
}

// A short row may turn above this node, with its neighbour on the outside.
bool may_turn(const EditableGraph& graph, int node, int outside, int beyond) {
  for (const int n : {node, outside, beyond})
    if (n < 0 || !is_calm(graph, n)) return false;
  return is_one_to_one(graph, node, Side::above) && is_one_to_one(graph, outside, Side::above);
}

// A stitch may be increased (side above) or decreased (side below) into two.
bool may_shape(const EditableGraph& graph, int node, Side side) {
  for (const int n : {node, graph.previous(node), graph.next(node)})
    if (n < 0 || !is_calm(graph, n)) return false;
  return is_one_to_one(graph, node, side) && graph.links(node, opposite(side)).size() <= 1;
}

// The node that a new stitch between two others shares its increase or decrease with; -1 if there is
// none that may be shaped.
int shaped_node(const EditableGraph& graph, int previous, int next, Side side, Beside beside) {
  const int neighbour = beside == Beside::previous ? previous : next;
  if (!is_one_to_one(graph, neighbour, side)) return -1;
  const int node = graph.links(neighbour, side).front();
  return may_shape(graph, node, opposite(side)) ? node : -1;
}

void shape(EditableGraph& graph, int node, Side side, int added, Beside beside) {
  Links links = graph.links(node, side);
  links.node[1] = added;
  // The neighbour lies before the new stitch: so do their columns.
  if (beside == Beside::next) std::swap(links.node[0], links.node[1]);
  graph.set_links(node, side, links);
  graph.set_links(added, opposite(side), Links{{node, -1}});
}

}  // namespace

bool is_calm(const EditableGraph& graph, int node) {
  if (graph.is_row_end(node)) return false;
  for (const Side side : {Side::below, Side::above})
    for (const int other : graph.links(node, side))
      if (graph.is_row_end(other)) return false;
  return true;
}

std::vector<int> insert_short_row(EditableGraph& graph, int first, int count) {
  if (count < fewest_between_turns) return {};
  const int row = graph.row(first);
  if (graph.is_junction(row, Side::above)) return {};
  if (graph.is_closed(row) && count + fewest_between_turns > graph.row_size(row)) return {};
  std::vector<int> run = {first};
  while (static_cast<int>(run.size()) < count && graph.next(run.back()) >= 0)
    run.push_back(graph.next(run.back()));
  if (static_cast<int>(run.size()) < count) return {};
  for (const int node : run)
    if (graph.links(node, Side::above).size() == 0) return {};
  const int before = graph.previous(first), after = graph.next(run.back());
  if (before < 0 || after < 0) return {};
  if (!may_turn(graph, first, before, graph.previous(before)) ||
      !may_turn(graph, run.back(), after, graph.next(after)))
    return {};

  const int added_row = graph.add_row(row, Side::above);
  std::vector<int> added;
  for (const int node : run) {
    const int made = graph.add_node(added_row, added.empty() ? -1 : added.back());
    const Links beyond = graph.links(node, Side::above);
    graph.set_links(made, Side::above, beyond);
    for (const int other : beyond) graph.replace_link(other, Side::below, node, made);
    graph.set_links(made, Side::below, Links{{node, -1}});
    graph.set_links(node, Side::above, Links{{made, -1}});
    added.push_back(made);
  }
  return added;
}

std::vector<int> insert_wale(EditableGraph& graph, int left, int count, Beside at_increase,
                             Beside at_decrease) {
  if (count < 1) return {};
  std::vector<int> before = {left};
  std::vector<int> after = {graph.next(left)};
  for (;;) {
    const int p = before.back(), n = after.back();
    if (p < 0 || n < 0 || graph.next(p) != n) return {};
    const int row = graph.row(p);
    if (graph.is_junction(row, Side::below) || graph.is_junction(row, Side::above)) return {};
    if (static_cast<int>(before.size()) == count) break;
    before.push_back(graph.links(p, Side::above).back());
    after.push_back(graph.links(n, Side::above).front());
  }
  const int increase = shaped_node(graph, left, after.front(), Side::below, at_increase);
  const int decrease =
      shaped_node(graph, before.back(), after.back(), Side::above, at_decrease);
  if (increase < 0 || decrease < 0) return {};

  std::vector<int> added;
  for (const int node : before) {
    const int made = graph.add_node(graph.row(node), node);
    if (!added.empty()) {
      graph.set_links(added.back(), Side::above, Links{{made, -1}});
      graph.set_links(made, Side::below, Links{{added.back(), -1}});
    }
    added.push_back(made);
  }
  shape(graph, increase, Side::above, added.front(), at_increase);
  shape(graph, decrease, Side::below, added.back(), at_decrease);
  return added;
}

}  // namespace meshknit
