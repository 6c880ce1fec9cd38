#include "meshknit/transfer/itinerary.h"

#include <algorithm>
#include <cstdlib>

namespace meshknit {
namespace {

class Walk {
 public:
  Walk(const Tube& tube, const Block& block, const Passes& passes, Ending ending)
      : stack_(tube.stacks[block.first]), passes_(passes), ending_(ending) {
    // A block spreads over the places between its ends; all of them stay within the range.
    const int reach = tube.stacks[block.last].place - stack_.place;
    lowest_ = tube.lowest - std::min(0, reach);
    highest_ = tube.highest - std::max(0, reach);
    for (std::size_t k = passes.size(); k-- > 0;) {
      leaves_later_[k] = leaves_later_[k + 1];
      leaves_later_[k][passes[k].from == Bed::back] = true;
    }
    way_.stops[0] = {stack_.side, stack_.place, false};
    step(0);
  }
  std::vector<Itinerary> found;

 private:
  void step(std::size_t k) {
    const Stop here = way_.stops[k];
    if (k == passes_.size()) {
      const bool home = here.side == stack_.goal_side && here.place == stack_.goal;
      if (!here.parked && (ending_ == Ending::any_hook || home)) found.push_back(way_);
      return;
    }
    if (ending_ == Ending::goal && too_late(here, k)) return;
    way_.stops[k + 1] = here;
    step(k + 1);
    if (here.bed() != passes_[k].from) return;
    Stop there = here;
    there.place += shift_of(passes_[k]);
    if (there.place < lowest_ || there.place > highest_) return;
    if (changes_side(passes_[k])) {
      if (here.parked || here.side == stack_.goal_side) return;
      there.side += here.side < stack_.goal_side ? 1 : -1;
    } else {
      there.parked = !here.parked;
    }
    way_.stops[k + 1] = there;
    ++way_.transfers;
    step(k + 1);
    --way_.transfers;
  }

  // A parked stack needs a pass back; one on a wrong hook of its own side needs one away and
  // one back.
  bool too_late(const Stop& here, std::size_t k) const {
    const int left = static_cast<int>(passes_.size() - k);
    const int ends = std::abs(stack_.goal_side - here.side);
    if (here.parked) return ends + 1 > left || !leaves_later_[k][here.bed() == Bed::back];
    if (ends > 0) return ends > left;
    return here.place != stack_.goal && !(leaves_later_[k][0] && leaves_later_[k][1]);
  }

  const Stack& stack_;
  const Passes& passes_;
  Ending ending_;
  int lowest_ = 0, highest_ = 0;
  std::array<std::array<bool, 2>, most_passes + 1> leaves_later_{};  // [pass][front, back]
  Itinerary way_;
};

// `b` is further round the tube by `turn` sides.
bool in_order(const Stop& a, Stop b, int turn, int racking) {
  b.side += turn;
  return in_order(a, b, racking);
}

bool within_slack(const Stack& a, const Stop& stop_a, const Stop& stop_b, int racking) {
  return std::abs(position(stop_a, racking) - position(stop_b, racking)) <= a.slack;
}

bool one_goal(const Stack& a, const Stack& b, int turn) {
  return a.goal_side == b.goal_side + turn && a.goal == b.goal;
}

}  // namespace

std::vector<Itinerary> itineraries(const Tube& tube, const Block& block, const Passes& passes,
                                   Ending ending) {
  return Walk(tube, block, passes, ending).found;
}

Itinerary beside(const Itinerary& itinerary, int places) {
  Itinerary shifted = itinerary;
  for (Stop& stop : shifted.stops) stop.place += places;
  return shifted;
}

bool compatible_at(const Stack& a, const Stop& stop_a, const Stop& stop_b, int turn,
                   int racking) {
  return within_slack(a, stop_a, stop_b, racking) && in_order(stop_a, stop_b, turn, racking);
}

bool compatible_in(const Pass& pass, const Stack& a, const Stop& from_a, const Stop& to_a,
                   const Stack& b, const Stop& from_b, const Stop& to_b, int turn) {
  if (!compatible_at(a, from_a, from_b, turn, pass.racking)) return false;
  // A loop that goes round an end lands on a new side, whose order is asked at that racking.
  if (!in_order(to_a, to_b, turn, pass.racking)) return false;
  const bool were_one = one_needle(from_a, from_b), are_one = one_needle(to_a, to_b);
  if (were_one != are_one) return are_one && one_goal(a, b, turn) && from_a == to_a;
  return true;
}

bool compatible(const Stack& a, const Itinerary& way_a, const Stack& b, const Itinerary& way_b,
                int turn, const Passes& passes) {
  const std::size_t count = passes.size();
  for (std::size_t k = 0; k < count; ++k)
    if (!compatible_in(passes[k], a, way_a.stops[k], way_a.stops[k + 1], b, way_b.stops[k],
                       way_b.stops[k + 1], turn))
      return false;
  return compatible_at(a, way_a.stops[count], way_b.stops[count], turn, 0);
}

}  // namespace meshknit
