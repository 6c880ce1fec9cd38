#include "meshknit/knit_graph/editable_graph.h"

#include "meshknit/knit_graph/closed_row_links.h"
#include "meshknit/knit_graph/rows.h"

namespace meshknit {

EditableGraph::EditableGraph(const KnitGraph& graph)
    : stitch_width_(graph.stitch_width),
      stitch_height_(graph.stitch_height),
      nodes_(graph.nodes.size()),
      rows_(graph.rows.size()) {
  const RowWalk walk(graph);
  for (int node = 0; node < size(); ++node) {
    Node& made = nodes_[node];
    made.row = walk.place(node).row;
    made.next = walk.next(node);
    made.previous = walk.previous(node);
    for (const Side side : {Side::below, Side::above}) {
      int k = 0;
      for (const int other : side == Side::above ? walk.above(node) : walk.below(node))
        made.links[static_cast<int>(side)].node[k++] = other;
    }
  }
  const int last = static_cast<int>(rows_.size()) - 1;
  for (int r = 0; r <= last; ++r) {
    rows_[r].first = graph.rows[r].nodes.front();
    rows_[r].size = static_cast<int>(graph.rows[r].nodes.size());
    rows_[r].closed = graph.rows[r].closed;
    rows_[r].beside = {r - 1, r < last ? r + 1 : -1};
  }
  const ClosedRowLinks closed = link_closed_rows(graph, walk);
  const int above = static_cast<int>(Side::above), below = static_cast<int>(Side::below);
  for (int r = 0; r <= last; ++r) {
    if (closed.is_split(r)) {
      rows_[r].junction[above] = true;
      for (const int branch : closed.above[r]) rows_[branch].junction[below] = true;
    }
    if (rows_[r].closed && closed.is_merge(r)) {
      rows_[r].junction[below] = true;
      for (const int branch : closed.below[r]) rows_[branch].junction[above] = true;
    }
  }
  begin_change();
}

void EditableGraph::begin_change() {
  nodes_before_ = nodes_.size();
  rows_before_ = rows_.size();
  old_nodes_.clear();
  old_rows_.clear();
}

void EditableGraph::undo_change() {
  // What was there before an element was changed first counts: go backwards.
  for (auto old = old_nodes_.rbegin(); old != old_nodes_.rend(); ++old)
    nodes_[old->first] = old->second;
  for (auto old = old_rows_.rbegin(); old != old_rows_.rend(); ++old)
    rows_[old->first] = old->second;
  nodes_.resize(nodes_before_);
  rows_.resize(rows_before_);
  begin_change();
}

EditableGraph::Node& EditableGraph::change_node(int node) {
  old_nodes_.push_back({node, nodes_[node]});
  return nodes_[node];
}

EditableGraph::Row& EditableGraph::change_row(int row) {
  old_rows_.push_back({row, rows_[row]});
  return rows_[row];
}

int EditableGraph::add_row(int beside, Side side) {
  const int added = static_cast<int>(rows_.size());
  const int there = static_cast<int>(side), back = static_cast<int>(opposite(side));
  const int beyond = rows_[beside].beside[there];
  Row row;
  row.beside[there] = beyond;
  row.beside[back] = beside;
  rows_.push_back(row);
  change_row(beside).beside[there] = added;
  if (beyond >= 0) change_row(beyond).beside[back] = added;
  return added;
}

int EditableGraph::add_node(int row, int previous) {
  const int added = size();
  Node node;
  node.row = row;
  node.previous = previous;
  node.next = previous >= 0 ? nodes_[previous].next : rows_[row].first;
  nodes_.push_back(node);
  Row& of_node = change_row(row);
  ++of_node.size;
  if (previous >= 0)
    change_node(previous).next = added;
  else
    of_node.first = added;
  if (node.next >= 0) change_node(node.next).previous = added;
  return added;
}

void EditableGraph::set_links(int node, Side side, const Links& links) {
  change_node(node).links[static_cast<int>(side)] = links;
}

void EditableGraph::replace_link(int node, Side side, int of, int by) {
  Links& links = change_node(node).links[static_cast<int>(side)];
  for (int& other : links.node)
    if (other == of) other = by;
}

KnitGraph EditableGraph::graph(std::vector<int>& number_of) const {
  KnitGraph graph;
  graph.stitch_width = stitch_width_;
  graph.stitch_height = stitch_height_;
  graph.nodes.resize(nodes_.size());
  number_of.clear();
  std::vector<int> number(nodes_.size(), -1);  // there, of a node here
  int first = 0;
  while (rows_[first].beside[static_cast<int>(Side::below)] >= 0)
    first = rows_[first].beside[static_cast<int>(Side::below)];
  for (int r = first; r >= 0; r = rows_[r].beside[static_cast<int>(Side::above)]) {
    KnitRow row;
    row.closed = rows_[r].closed;
    for (int node = rows_[r].first, k = 0; k < rows_[r].size; node = nodes_[node].next, ++k) {
      number[node] = static_cast<int>(number_of.size());
      row.nodes.push_back(number[node]);
      number_of.push_back(node);
    }
    graph.rows.push_back(std::move(row));
  }
  for (std::size_t k = 0; k < number_of.size(); ++k)
    for (const int above : links(number_of[k], Side::above))
      graph.columns.push_back({static_cast<int>(k), number[above]});
  return graph;
}

}  // namespace meshknit
