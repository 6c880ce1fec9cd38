#include "meshknit/emit/yarn_ends.h"

#include <algorithm>

namespace meshknit {

std::vector<Needle> bring_in(ProgramBuilder& program, const MachineProfile& profile,
                             const std::string& carrier, const Hook& first, Side side,
                             const PlaceRange& room) {
  const Source anchor{Source::Kind::anchor, -1};
  const Side first_way = profile.first_stitch_leftward ? Side::left : Side::right;
  const int behind =
      side == Side::left ? 1 : -1;  // where the yarn of the first stitch comes from
  const int from = first.n + behind, to = first.n + 3 * behind;
  const int nearest =
      std::clamp(0, room.lowest - std::min(from, to), room.highest - std::max(from, to));
  std::vector<Needle> anchors;
  const auto tuck = [&](Side way, int places_behind) {
    const int n = first.n + behind * places_behind + nearest;
    const Needle needle = half_gauge_needle({Bed::front, n, true});
    program.tuck(way, needle, carrier, anchor);
    anchors.push_back(needle);
  };
  program.carrier(profile.has_inserting_hook ? Op::inhook : Op::in, carrier);
  if (side == first_way) {
    for (const int places : {3, 2, 1}) tuck(side, places);
  } else {
    // Out past the yarn's place, then back through the gap, so that the carrier arrives from
    // behind the first stitch.
    tuck(first_way, 1);
    tuck(first_way, 3);
    tuck(side, 2);
  }
  if (profile.has_inserting_hook) program.carrier(Op::releasehook, carrier);
  return anchors;
}

void take_out(ProgramBuilder& program, const MachineProfile& profile,
              const std::string& carrier) {
  program.carrier(profile.has_inserting_hook ? Op::outhook : Op::out, carrier);
}

}  // namespace meshknit
