#include "meshknit/emit/waste_yarn.h"

#include <algorithm>
#include <string>

#include "meshknit/emit/yarn_ends.h"

namespace meshknit {
namespace {

const Source kWaste{Source::Kind::waste, -1};

struct Round {
  std::vector<Hook> hooks;
  Direction direction;
  Side side(size_t i) const { return travel(hooks[i].bed, direction); }
};

// Begins with the front bed, on the side from which the machine's carriers come.
Round round_from_carriers(const std::vector<Hook>& anticlockwise, bool leftward) {
  Round round{anticlockwise, Direction::anticlockwise};
  size_t n = anticlockwise.size(), first_front = 0;
  while (anticlockwise[first_front].bed != Bed::front ||
         anticlockwise[(first_front + n - 1) % n].bed == Bed::front)
    ++first_front;
  std::rotate(round.hooks.begin(), round.hooks.begin() + static_cast<long>(first_front),
              round.hooks.end());
  if (leftward) {
    round.direction = Direction::clockwise;
    std::reverse(round.hooks.begin(), round.hooks.end());
    const auto front = std::find_if(round.hooks.begin(), round.hooks.end(),
                                    [](const Hook& hook) { return hook.bed == Bed::front; });
    std::rotate(round.hooks.begin(), front, round.hooks.end());
  }
  return round;
}

void knit_rounds(ProgramBuilder& program, const std::string& carrier, const Round& round,
                 int rounds) {
  for (int r = 0; r < rounds; ++r)
    for (size_t i = 0; i < round.hooks.size(); ++i)
      program.knit(round.side(i), needle_of(round.hooks[i]), carrier, kWaste);
}

void drop_all(ProgramBuilder& program, const std::vector<Needle>& needles) {
  for (const Needle& needle : needles) program.drop(needle);
}

// One round, which pulls out and parts object and waste.
void knit_draw_thread(ProgramBuilder& program, const MachineProfile& profile,
                      const Round& round, const PlaceRange& room) {
  const std::vector<Needle> anchors =
      bring_in(program, profile, profile.draw_carrier, round.hooks[0], round.side(0), room);
  knit_rounds(program, profile.draw_carrier, round, 1);
  drop_all(program, anchors);
  take_out(program, profile, profile.draw_carrier);
}

}  // namespace

void knit_waste_before(ProgramBuilder& program, const MachineProfile& profile,
                       const std::vector<Hook>& hooks, const PlaceRange& room) {
  const Round round = round_from_carriers(hooks, profile.first_stitch_leftward);
  const std::vector<Needle> anchors =
      bring_in(program, profile, profile.waste_carrier, round.hooks[0], round.side(0), room);
  for (const size_t begin : {0, 1})
    for (size_t i = begin; i < round.hooks.size(); i += 2)
      program.tuck(round.side(i), needle_of(round.hooks[i]), profile.waste_carrier, kWaste);
  drop_all(program, anchors);
  knit_rounds(program, profile.waste_carrier, round,
              std::max(profile.waste_rounds, profile.take_down_rounds));
  take_out(program, profile, profile.waste_carrier);
  if (!profile.draw_carrier.empty()) knit_draw_thread(program, profile, round, room);
}

void knit_waste_after(ProgramBuilder& program, const MachineProfile& profile,
                      const std::vector<Hook>& hooks, const PlaceRange& room) {
  const Round round = round_from_carriers(hooks, profile.first_stitch_leftward);
  const std::vector<Needle> anchors =
      bring_in(program, profile, profile.waste_carrier, round.hooks[0], round.side(0), room);
  knit_rounds(program, profile.waste_carrier, round, profile.waste_rounds);
  take_out(program, profile, profile.waste_carrier);
  drop_all(program, anchors);
  for (const Hook& hook : round.hooks) program.drop(needle_of(hook));
}

}  // namespace meshknit
