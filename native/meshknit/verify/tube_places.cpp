#include "meshknit/verify/tube_places.h"

#include <algorithm>

namespace meshknit {

void TubePlaces::touched(int tube) {
  if (std::find(touched_.begin(), touched_.end(), tube) == touched_.end()) {
    touched_.push_back(tube);
  }
}

void TubePlaces::check(int line) {
  if (touched_.empty()) return;
  for (const int tube : touched_) {
    if (tubes_.order(tube).size() == 0) continue;
    for (const int other : tubes_.held_tubes()) {
      if (other == tube) continue;
      const int side = tubes_.side(tube, other);
      if (side == 0) continue;
      if (known(tube, other) == -side) {
        log_.error("tubes-crossed", line,
                   "two tubes have changed places on the beds; their fabrics would be wound "
                   "round each other");
      }
      set(tube, other, side);
    }
  }
  touched_.clear();
}

void TubePlaces::parted(int tube, int from) {
  for (const int other : tubes_.held_tubes()) {
    if (other != tube && other != from) set(tube, other, known(from, other));
  }
  touched(tube);
  touched(from);
}

void TubePlaces::met(int tube, int with) {
  for (const int other : tubes_.held_tubes()) {
    if (other == tube) continue;
    if (known(with, other) != known(tube, other)) set(tube, other, 0);
  }
  touched(tube);
}

int TubePlaces::known(int tube, int other) const {
  const auto found = sides_.find(std::minmax(tube, other));
  if (found == sides_.end()) return 0;
  return tube < other ? found->second : -found->second;
}

void TubePlaces::set(int tube, int other, int side) {
  sides_[std::minmax(tube, other)] = tube < other ? side : -side;
}

}  // namespace meshknit
