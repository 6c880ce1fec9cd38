#pragma once

#include <array>
#include <utility>
#include <vector>

#include "meshknit/knit_graph/knit_graph.h"

namespace meshknit {

/// The two sides of a row.
enum class Side { below = 0, above = 1 };
constexpr Side opposite(Side side) { return side == Side::below ? Side::above : Side::below; }

/// A knit graph whose topology can be changed a stitch at a time, and changed back. It knows who is
/// joined to whom; where nodes lie is the caller's. Nodes keep their numbers, new ones come after them.
class EditableGraph {
 public:
  /// Columns of a node on one side: at most two, in yarn order of their row.
  struct Links {
    std::array<int, 2> node = {-1, -1};
    int size() const { return (node[0] >= 0) + (node[1] >= 0); }
    int front() const { return node[0]; }
    int back() const { return node[1] >= 0 ? node[1] : node[0]; }
    const int* begin() const { return node.data(); }
    const int* end() const { return node.data() + size(); }
  };

  /// Requires: check_knit_graph(graph) finds no errors, but lengths may be missing.
  explicit EditableGraph(const KnitGraph& graph);

  int size() const { return static_cast<int>(nodes_.size()); }
  int row(int node) const { return nodes_[node].row; }
  int next(int node) const { return nodes_[node].next; }          ///< -1 at a short row's end
  int previous(int node) const { return nodes_[node].previous; }  ///< -1 at a short row's end
  const Links& links(int node, Side side) const {
    return nodes_[node].links[static_cast<int>(side)];
  }
  bool is_row_end(int node) const { return next(node) < 0 || previous(node) < 0; }
  bool is_closed(int row) const { return rows_[row].closed; }
  int row_size(int row) const { return rows_[row].size; }
  /// True where tubes part or meet on this side of a row: its columns there are one to one and
  /// stay as they are (Properties 5 and 6).
  bool is_junction(int row, Side side) const {
    return rows_[row].junction[static_cast<int>(side)];
  }

  /// Begins a change that may be taken back; what was changed before is kept.
  void begin_change();
  /// Takes back what was changed since then.
  void undo_change();

  /// A new open row without nodes, beside this one in the order in which rows are made.
  int add_row(int beside, Side side);
  /// A new node without columns after `previous`, or, with -1, as the first of an open row. In a closed
  /// row, the list of nodes still begins where it did.
  int add_node(int row, int previous);
  void set_links(int node, Side side, const Links& links);
  /// Puts `by` in place of `of` among the columns of a node.
  void replace_link(int node, Side side, int of, int by);

  /// Rows, columns and sizes; nodes are numbered row by row. `number_of` gets the number here of
  /// each node there; positions, times and lengths are for the caller to fill in.
  KnitGraph graph(std::vector<int>& number_of) const;

 private:
  struct Node {
    int row = -1, next = -1, previous = -1;
    std::array<Links, 2> links;
  };
  struct Row {
    int first = -1, size = 0;
    bool closed = false;
    std::array<bool, 2> junction = {false, false};
    std::array<int, 2> beside = {-1, -1};  // rows made before and after it
  };

  Node& change_node(int node);
  Row& change_row(int row);

  double stitch_width_, stitch_height_;
  std::vector<Node> nodes_;
  std::vector<Row> rows_;
  // What the present change found: how much there was, and what was overwritten.
  std::size_t nodes_before_ = 0, rows_before_ = 0;
  std::vector<std::pair<int, Node>> old_nodes_;
  std::vector<std::pair<int, Row>> old_rows_;
};

}  // namespace meshknit
