#pragma once

#include <array>
#include <map>
#include <vector>

#include "meshknit/machine/needle.h"

namespace meshknit {

/// The cyclic order of one tube's columns (a column is what hangs on one needle), followed
/// through all operations (primer, section 7, step 6).
///
/// The order is a list, kept from the making of the columns on: anticlockwise, seen from above
/// the beds, as in machine/needle.h. Knitting replaces loops and leaves it alone; moving a
/// column changes where it hangs, not where it stands in the list. Two questions are asked of
/// it:
///  - at rest: does reading the front bed left to right and then the back bed right to left
///  give the list?
///  - under way: on each bed, do needle numbers go round the list up once and down once? A
///  parked
///    loop keeps its place in the list, so loops of both sides may mingle on a bed; but a loop
///    that was carried past another of its side makes the numbers turn once more.
/// All operations cost O(log n), but for `move` to a bed far (along the list) from every other
/// column on it.
class TubeOrder {
 public:
  /// A new column on a needle where no column is; it goes to the place in the list that its
  /// needle has in the reading order.
  int insert(const Needle& needle);
  /// A new column anticlockwise beside another one in the list, whatever its needle; -1: the first.
  int insert_after(int before, const Needle& needle);
  void move(int column, const Needle& to);
  void remove(int column);

  int next(int column) const { return columns_[column].next; }  ///< anticlockwise
  int previous(int column) const { return columns_[column].previous; }
  bool neighbours(int a, int b) const { return next(a) == b || previous(a) == b; }

  Needle needle(int column) const;
  int size() const { return static_cast<int>(reading_[0].size() + reading_[1].size()); }
  /// Requires: is_on(bed).
  int leftmost(Bed bed) const { return reading_[side(bed)].begin()->second; }
  int rightmost(Bed bed) const { return reading_[side(bed)].rbegin()->second; }
  bool is_on(Bed bed) const { return !reading_[side(bed)].empty(); }
  /// The column that comes after or before a needle in the reading order, round again at its end.
  /// Requires: size() > 0.
  int first_after(const Needle& needle) const { return read_next(needle.bed, key_of(needle)); }
  int last_before(const Needle& needle) const {
    return read_previous(needle.bed, key_of(needle));
  }

  bool at_rest() const { return misplaced_ == 0; }

  /// How often the needle numbers of a bed turn along the list; at most 2 if nothing was passed
  /// over.
  int turns(Bed bed) const { return turns_[side(bed)]; }

 private:
  struct Column {
    int next = -1, previous = -1;
    Bed bed = Bed::front;
    int key = 0;  // orders hooks and sliders of one bed
    int bed_next = -1, bed_previous = -1;
    bool misplaced = false, turn = false;
  };

  static int key_of(const Needle& needle) { return 2 * needle.index + (needle.slider ? 1 : 0); }
  static int side(Bed bed) { return bed == Bed::front ? 0 : 1; }
  int read_next(Bed bed, int key) const;
  int read_previous(Bed bed, int key) const;
  void hang(int column, const Needle& needle);
  void unhang(int column);
  void refresh_place(int column);
  void refresh_turn(int column);

  std::vector<Column> columns_;
  std::array<std::map<int, int>, 2> reading_;  // key -> column
  std::array<int, 2> turns_{};
  int misplaced_ = 0;
};

}  // namespace meshknit
