#include "meshknit/schedule/needle_offsets.h"

#include <algorithm>

#include "meshknit/schedule/bed_row.h"
#include "meshknit/schedule/layout_cost.h"

namespace meshknit {
namespace {

constexpr int kFreePlaces = 4;  // at each end of the bed

// Twice the middle, so that it stays an integer.
int middle(const PlaceRange& range) { return range.lowest + range.highest; }

int width(const PlaceRange& range) { return range.highest - range.lowest + 1; }

class BedWalk {
 public:
  BedWalk(const SteppedTubes& tubes, const std::vector<Connection>& connections,
          const BedOrder& order, const std::vector<TubeLayouts>& layouts,
          const PlaceRange& walls, int start_middle)
      : tubes_(tubes),
        connections_(connections),
        order_(order),
        layouts_(layouts),
        start_middle_(start_middle),
        bed_(tubes.tubes.size(), walls),
        changes_(tubes.tubes.size(), 0) {}

  PlacedTubes run() {
    for (; turn_ < tubes_.turns.size(); ++turn_) {
      const SteppedTubes::Turn& at = tubes_.turns[turn_];
      if (at.step == 0) begin(at.tube);
      bed_.set_order(order_.held[turn_]);
      knit(at.tube, at.step);
      const TubeSteps& tube = tubes_.tubes[at.tube];
      const bool last = at.step + 1 == static_cast<int>(tube.steps.size());
      if (last && tube.above.empty()) bed_.take_off(at.tube);
    }
    return {bed_.take_steps(), best_moves_ && !bed_.pushed()};
  }

  const PlaceRange& used() const { return bed_.used(); }

 private:
  void begin(int tube) {
    if (tubes_.tubes[tube].below.empty()) return start(tube);
    for (size_t c = 0; c < connections_.size(); ++c) {
      const Connection& connection = connections_[c];
      const int left = order_.left_part[c];
      if (connection.split && connection.first == tube) part(connection, left);
      if (!connection.split && connection.whole == tube) meet(connection, left);
    }
  }

  void start(int tube) {
    bed_.set_order(order_.held[turn_]);
    BedLayout layout = layouts_[tube].layouts.front();
    const size_t row = bed_.row_of(tube);
    OffsetChoice free = bed_.free_offsets(row, layout);
    if (free.lowest > free.highest) {
      bed_.make_room(row, layout);
      free = bed_.free_offsets(row, layout);
    }
    int wanted = (start_middle_ - middle(places_of(layout))) / 2;
    if (row > 0) {
      wanted = free.lowest + places_between_later(row - 1);
    } else if (bed_.order().size() > 1) {
      wanted = free.highest - places_between_later(row);
    }
    layout.place += std::clamp(wanted, free.lowest, free.highest);
    bed_.hang(tube, layout);
  }

  // Places that tubes will need which start between this row and the next while both hang.
  int places_between_later(size_t row) const {
    const int left = bed_.order()[row], right = bed_.order()[row + 1];
    int most = 0;
    for (size_t turn = turn_ + 1; turn < order_.held.size(); ++turn) {
      const std::vector<int>& held = order_.held[turn];
      const auto from = std::find(held.begin(), held.end(), left);
      const auto to = std::find(from, held.end(), right);
      if (to == held.end()) break;
      int places = 0;
      for (auto tube = from + 1; tube < to; ++tube)
        places += width(places_of(layouts_[*tube].layouts.front())) + kFreeBetween;
      most = std::max(most, places);
    }
    return most;
  }

  void part(const Connection& connection, int left) {
    const ConnectionLayout layout = connection_layout(connection, left);
    const int place = bed_.layout(connection.whole).place;
    bed_.take_off(connection.whole);
    for (std::size_t p = 0; p < layout.parts.size(); ++p) {
      BedLayout own = layout.parts[p];
      own.place += place;
      bed_.hang(connection.parts[p], own);
    }
  }

  // The order is still that of the step before, with all parts in it. The largest stays where it is,
  // the others come to it, the nearest first.
  void meet(const Connection& connection, int left) {
    const ConnectionLayout layout = connection_layout(connection, left);
    const int parts = static_cast<int>(connection.parts.size());
    int still = 0;
    for (int p = 1; p < parts; ++p)
      if (layout.parts[p].slots >= layout.parts[still].slots) still = p;
    const int origin = bed_.layout(connection.parts[still]).place - layout.parts[still].place;
    const auto fetch = [&](int p) {
      const int tube = connection.parts[p];
      bed_.shift(tube, origin + layout.parts[p].place - bed_.layout(tube).place);
    };
    for (int p = still - 1; p >= 0; --p) fetch(p);
    for (int p = still + 1; p < parts; ++p) fetch(p);
    BedLayout whole = layout.whole;
    whole.place = origin;
    for (const int part : connection.parts) bed_.take_off(part);
    bed_.hang(connection.whole, whole);
  }

  void knit(int tube, int step) {
    const TubeLayouts& own = layouts_[tube];
    const int change = changes_[tube];
    const bool changes =
        change < static_cast<int>(own.maps.size()) && own.from_step[change] == step;
    BedLayout next = changes ? own.layouts[change + 1] : bed_.layout(tube);
    next.place = bed_.layout(tube).place;
    const size_t row = bed_.row_of(tube);
    OffsetChoice choice = bed_.free_offsets(row, next);
    if (choice.lowest > choice.highest) {
      bed_.make_room(row, next);
      next.place = bed_.layout(tube).place;
      choice = bed_.free_offsets(row, next);
    }
    const BedLayout before = bed_.layout(tube);
    choice.liked = liked_offset(tube, row, places_of(next), choice);
    if (changes) {
      const SlotMap& map = own.maps[change];
      const MoveCost cost = meter_.measure(map, before, next, choice);
      best_moves_ = best_moves_ && !(meter_.measure(map, before, next) < cost);
      next.place += cost.offset;
      ++changes_[tube];
    } else {
      next.place += std::clamp(0, choice.lowest, choice.highest);
    }
    bed_.knit(tube, step, next);
  }

  // Towards the tube that it will meet, if they are neighbours already; one that will meet two stays
  // between them.
  int liked_offset(int tube, size_t row, const PlaceRange& unmoved,
                   const OffsetChoice& choice) const {
    const std::vector<int>& held = bed_.order();
    for (size_t c = 0; c < connections_.size(); ++c) {
      if (connections_[c].split) continue;
      std::vector<int> parts = connections_[c].parts;
      if (order_.left_part[c] != 0) std::reverse(parts.begin(), parts.end());
      const auto own = std::find(parts.begin(), parts.end(), tube);
      if (own == parts.end()) continue;
      const bool right =
          row + 1 < held.size() && own + 1 != parts.end() && held[row + 1] == own[1];
      const bool left = row > 0 && own != parts.begin() && held[row - 1] == own[-1];
      if (right != left) return right ? choice.highest : choice.lowest;
    }
    return (bed_.first_middle(tube) - middle(unmoved)) / 2;
  }

  const SteppedTubes& tubes_;
  const std::vector<Connection>& connections_;
  const BedOrder& order_;
  const std::vector<TubeLayouts>& layouts_;
  int start_middle_;
  BedRow bed_;
  std::vector<int> changes_;  // [tube] of its layout so far
  size_t turn_ = 0;
  MoveMeter meter_;
  bool best_moves_ = true;
};

void move_all(PlacedTubes& placed, int offset, const PlaceRange& bed) {
  for (PlacedStep& step : placed.steps) {
    step.before.place += offset;
    step.after.place += offset;
    step.room = {std::max(bed.lowest, step.room.lowest + offset),
                 std::min(bed.highest, step.room.highest + offset)};
  }
}

}  // namespace

PlaceRange usable_places(const MachineProfile& profile) {
  // Place n is needles 2n and 2n + 1 of both beds, which are numbered from 1.
  return {1 + kFreePlaces, profile.needles / 2 - 1 - kFreePlaces};
}

PlacedTubes place_tubes(const SteppedTubes& tubes, const std::vector<Connection>& connections,
                        const BedOrder& order, const std::vector<TubeLayouts>& layouts,
                        const MachineProfile& profile) {
  const PlaceRange usable = usable_places(profile), bed{1, profile.needles / 2 - 1};
  BedWalk free_walk(tubes, connections, order, layouts, kAnywhere, 0);
  PlacedTubes placed = free_walk.run();
  if (width(free_walk.used()) <= width(usable)) {
    move_all(placed, (middle(usable) - middle(free_walk.used())) / 2, bed);
    return placed;
  }
  placed = BedWalk(tubes, connections, order, layouts, usable, middle(usable)).run();
  placed.optimal = false;
  move_all(placed, 0, bed);
  return placed;
}

}  // namespace meshknit
