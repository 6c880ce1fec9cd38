#include "meshknit/schedule/needle_offsets.h"

#include <algorithm>

#include "meshknit/schedule/layout_cost.h"

namespace meshknit {
namespace {

constexpr int kFreePlaces = 4;  // at each end of the bed

// Twice the middle, so that it stays an integer.
int middle(const PlaceRange& range) { return range.lowest + range.highest; }

int width(const PlaceRange& range) { return range.highest - range.lowest + 1; }

PlaceRange unite(const PlaceRange& a, const PlaceRange& b) {
  return {std::min(a.lowest, b.lowest), std::max(a.highest, b.highest)};
}

// Follows the tube from its first layout on; every layout stays within `limits`. Returns all
// places used.
PlaceRange follow(std::vector<BedLayout>& layouts, const std::vector<SlotMap>& maps,
                  const PlaceRange& limits, int wanted_middle) {
  ShiftMeter meter;
  PlaceRange used = places_of(layouts[0]);
  for (size_t i = 0; i < maps.size(); ++i) {
    BedLayout& next = layouts[i + 1];
    next.place = layouts[i].place;
    const PlaceRange unmoved = places_of(next);
    const OffsetChoice choice{limits.lowest - unmoved.lowest, limits.highest - unmoved.highest,
                              (wanted_middle - middle(unmoved)) / 2};
    next.place += meter.measure(maps[i], layouts[i], next, choice).offset;
    used = unite(used, places_of(next));
  }
  return used;
}

}  // namespace

PlaceRange usable_places(const MachineProfile& profile) {
  // Place n is needles 2n and 2n + 1 of both beds, which are numbered from 1.
  return {1 + kFreePlaces, profile.needles / 2 - 1 - kFreePlaces};
}

bool place_layouts(std::vector<BedLayout>& layouts, const std::vector<SlotMap>& maps,
                   const MachineProfile& profile) {
  const PlaceRange usable = usable_places(profile);
  const PlaceRange anywhere{-100 * profile.needles, 100 * profile.needles};
  layouts[0].place = 0;
  const PlaceRange used = follow(layouts, maps, anywhere, middle(places_of(layouts[0])));
  if (width(used) <= width(usable)) {
    const int offset = (middle(usable) - middle(used)) / 2;
    for (BedLayout& layout : layouts) layout.place += offset;
    return true;
  }
  layouts[0].place = (middle(usable) - middle(places_of(layouts[0]))) / 2;
  follow(layouts, maps, usable, middle(usable));
  return false;
}

}  // namespace meshknit
