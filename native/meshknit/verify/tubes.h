#pragma once

#include <utility>
#include <vector>

#include "meshknit/verify/tube_order.h"

namespace meshknit {

/// All tubes on the beds. A tube is a ring of columns (verify/tube_order.h), each with its own
/// order; columns and tubes are numbered over all of them and never again.
///
/// Seen from above, the beds are one circle: the front bed left to right, then the back bed right to
/// left. Tubes are clear of each other while the polygons that their columns make on that circle
/// are: no tube has columns on both sides of a line between two columns of another. So tubes may
/// stand side by side, also along a slanting line, and one that lies wholly on one bed may lie
/// opposite another, or in a gap of it; rackings change nothing.
class Tubes {
 public:
  /// A new tube with one column. Returns the column.
  int begin(const Needle& needle);
  /// A new column of a tube with columns, at its place in the reading order.
  int insert(int tube, const Needle& needle);
  void move(int column, const Needle& to);
  void remove(int column);

  /// Tubes part or meet: `second` becomes the anticlockwise neighbour of `first`
  /// (verify/trace_columns.h draws it). Where a tube parts, `first` keeps its number; where two
  /// meet, they have that of `first`. Returns the number of the tube that is new, -1 for none.
  int meet(int first, int second);

  bool is_held(int column) const { return columns_[column].tube >= 0; }
  int tube_of(int column) const { return columns_[column].tube; }
  Needle needle(int column) const;
  int next(int column) const;      ///< anticlockwise
  int previous(int column) const;  ///< clockwise

  const TubeOrder& order(int tube) const { return tubes_[tube].order; }
  /// Tubes with columns, in ascending order.
  const std::vector<int>& held_tubes() const { return held_; }

  /// True if the tubes are not clear of each other any more since the column came where it is.
  bool crosses(int column, int other) const;
  /// True if the tubes are not clear of each other.
  bool tube_crosses(int tube, int other) const;
  /// True if the tube has columns on both sides of the line between two needles.
  bool lies_between(int tube, const Needle& a, const Needle& b) const;
  /// 1 if `tube` stands left of the other on every bed where both are, -1 if right; 0 if no bed
  /// tells.
  int side(int tube, int other) const;

 private:
  struct Column {
    int tube = -1;
    int own = -1;  // its number in the tube's order
  };
  struct Tube {
    TubeOrder order;
    std::vector<int> columns;  // by their numbers in `order`
  };

  using Ring = std::vector<std::pair<int, Needle>>;

  Ring ring_from(int column) const;
  void fill(int tube, const Ring& ring);
  void hold(int tube, bool held);

  std::vector<Column> columns_;
  std::vector<Tube> tubes_;
  std::vector<int> held_;
};

}  // namespace meshknit
