#pragma once

#include <cstddef>
#include <utility>
#include <vector>

#include "meshknit/schedule/bed_layout.h"
#include "meshknit/schedule/layout_cost.h"
#include "meshknit/schedule/needle_offsets.h"

namespace meshknit {

/// The tubes that hang on the machine, left to right, each with its layout at a place; knows how
/// much room they leave each other and moves them aside. Writes down every move.
class BedRow {
 public:
  /// Layouts stay within `walls`.
  BedRow(std::size_t tubes, const PlaceRange& walls) : walls_(walls), hung_(tubes) {}

  /// The order from here on, by tube number; tubes in it need not hang yet.
  void set_order(const std::vector<int>& left_to_right) { order_ = left_to_right; }
  const std::vector<int>& order() const { return order_; }
  std::size_t row_of(int tube) const;

  void hang(int tube, const BedLayout& layout);
  void take_off(int tube) { hung_[tube].hangs = false; }
  bool hangs(int tube) const { return hung_[tube].hangs; }
  const BedLayout& layout(int tube) const { return hung_[tube].layout; }
  /// Twice the middle that the tube had when it was hung up, moved along with the whole tube.
  int first_middle(int tube) const { return hung_[tube].middle; }

  /// By how much a layout may move so that walls and neighbours leave it room in this row;
  /// none if lowest > highest.
  OffsetChoice free_offsets(std::size_t row, const BedLayout& layout) const;
  /// Pushes neighbours away until the layout, at the place of the tube in this row, has room between
  /// them. Tubes that have just parted never hang more than kFreeBetween apart meanwhile; where they
  /// must go further, they go in turn, the tube in this row too if it hangs.
  /// Ensures: free_offsets of the layout at the tube's place are not empty, if walls leave room for all.
  void make_room(std::size_t row, const BedLayout& layout);

  /// A step of the tube, after which it hangs in another layout.
  void knit(int tube, int step, const BedLayout& after);
  /// Moves a whole tube, as far at a time as a racking goes. Others do not move.
  void shift(int tube, int places);

  /// All places ever used.
  const PlaceRange& used() const { return used_; }
  bool pushed() const { return pushed_; }
  std::vector<PlacedStep> take_steps() { return std::move(steps_); }

 private:
  struct Hung {
    BedLayout layout;
    int middle = 0;
    bool hangs = false;
  };

  int neighbour(std::size_t row, bool right) const;
  bool is_tied(std::size_t row, bool right) const;
  int free_way(std::size_t row, bool right) const;
  int way_to_wall(std::size_t row, bool right) const;
  int stacks_in_the_way(std::size_t row, bool right, int distance) const;
  void push(std::size_t row, bool right, int distance);
  void clear_side(std::size_t row, bool right, int distance);
  void write_down(int tube, int step, const BedLayout& after);
  void use(const PlaceRange& range);

  PlaceRange walls_;
  std::vector<Hung> hung_;  // [tube]
  std::vector<int> order_;
  PlaceRange used_;
  bool any_used_ = false, pushed_ = false;
  std::vector<PlacedStep> steps_;
};

}  // namespace meshknit
