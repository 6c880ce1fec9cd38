#include "meshknit/schedule/room_on_bed.h"

#include <algorithm>
#include <string>

#include "meshknit/core/error.h"
#include "meshknit/schedule/needle_offsets.h"

namespace meshknit {
namespace {

void sort_unique(std::vector<int>& nodes) {
  std::sort(nodes.begin(), nodes.end());
  nodes.erase(std::unique(nodes.begin(), nodes.end()), nodes.end());
}

int fewest_places(int slots) { return (slots + 1) / 2; }

// Loops on every needle at the fullest moment of a step: decreases and tucks pile up.
std::vector<int> stack_heights(const StitchTrace& trace, const TubeStep& step) {
  std::vector<int> heights(step.map.slots(), 0);
  for (int stack = 0; stack < step.map.stacks(); ++stack)
    heights[step.map.slot_of(stack) % step.map.slots()] +=
        static_cast<int>(step.before[stack].size());
  for (int s = step.first_stitch; s <= step.last_stitch; ++s)
    if (trace.stitches[s].kind == StitchKind::tuck)
      ++heights[step.stitch_slot[s - step.first_stitch]];
  return heights;
}

// A tube while a step of it or of another one is knit: what it holds then.
struct Held {
  const std::vector<LoopStack>* loops = nullptr;
  int slots = 0;  // at the most
};

int places_for(const std::vector<Held>& held) {
  int sum = kFreeBetween * (static_cast<int>(held.size()) - 1);
  for (const Held& tube : held) sum += fewest_places(tube.slots);
  return sum;
}

// What a tube holds after a step.
const std::vector<LoopStack>& after_step(const TubeSteps& tube, size_t step) {
  return step + 1 < tube.steps.size() ? tube.steps[step + 1].before : tube.end;
}

std::vector<Held> widest_moment(const SteppedTubes& tubes, const BedOrder& order,
                                int& turn_of) {
  std::vector<int> done(tubes.tubes.size(), 0);  // [tube] steps
  std::vector<Held> widest;
  for (size_t turn = 0; turn < tubes.turns.size(); ++turn) {
    ++done[tubes.turns[turn].tube];
    std::vector<Held> held;
    for (const int t : order.held[turn]) {
      const TubeSteps& tube = tubes.tubes[t];
      const std::vector<LoopStack>& loops =
          done[t] == 0 ? tube.steps[0].before
                       : after_step(tube, static_cast<size_t>(done[t]) - 1);
      held.push_back({&loops, static_cast<int>(loops.size())});
    }
    if (!widest.empty() && places_for(held) <= places_for(widest)) continue;
    widest = held;
    turn_of = static_cast<int>(turn);
  }
  return widest;
}

}  // namespace

void refuse_tall_stacks(const StitchTrace& trace, const SteppedTubes& tubes,
                        const MachineProfile& profile) {
  Problem problem;
  problem.code = "stack-too-high";
  int tallest = 0;
  for (const SteppedTubes::Turn& turn : tubes.turns) {
    const TubeStep& step = tubes.tubes[turn.tube].steps[turn.step];
    const std::vector<int> heights = stack_heights(trace, step);
    for (int s = step.first_stitch; s <= step.last_stitch; ++s) {
      const StitchKind kind = trace.stitches[s].kind;
      if (kind != StitchKind::tuck && kind != StitchKind::decrease) continue;
      const int height = heights[step.stitch_slot[s - step.first_stitch]];
      if (height <= profile.max_stack) continue;
      tallest = std::max(tallest, height);
      problem.elements.stitches.push_back(s);
      problem.elements.nodes.push_back(trace.stitches[s].node);
    }
  }
  if (tallest == 0) return;
  sort_unique(problem.elements.nodes);
  const std::size_t nodes = problem.elements.nodes.size();
  problem.message = "At " + std::to_string(nodes) + (nodes == 1 ? " node" : " nodes") +
                    " short rows or decreases end on top of each other: up to " +
                    std::to_string(tallest) + " loops on a needle that holds " +
                    std::to_string(profile.max_stack) + ".";
  problem.remedy =
      "Change the knitting times or the stitch size there, so that short rows end further "
      "apart.";
  throw NotKnittable({problem});
}

void refuse_too_wide(const StitchTrace& trace, const SteppedTubes& tubes, const BedOrder& order,
                     const MachineProfile& profile) {
  int turn = 0;
  const std::vector<Held> widest = widest_moment(tubes, order, turn);
  const PlaceRange usable = usable_places(profile);
  const int places = usable.highest - usable.lowest + 1, needed = places_for(widest);
  if (needed <= places) return;

  const TubeStep& step = tubes.tubes[tubes.turns[turn].tube].steps[tubes.turns[turn].step];
  Problem problem;
  problem.code = "too-wide";
  int stitches = 0;
  std::string each;
  for (const Held& tube : widest) {
    stitches += tube.slots;
    each += (each.empty() ? "" : " + ") + std::to_string(tube.slots);
  }
  const int between = kFreeBetween * (static_cast<int>(widest.size()) - 1);
  problem.message =
      (widest.size() == 1
           ? "The widest row has " + each + " stitches"
           : "At stitch " + std::to_string(step.last_stitch) + " " +
                 std::to_string(widest.size()) + " tubes hang side by side, with " + each +
                 " stitches round them") +
      ", but this machine has room for " + std::to_string(std::max(0, 2 * (places - between))) +
      (widest.size() == 1 ? " round a tube." : " round all of them.");
  const int percent = std::max(0, 100 * (places - between) / fewest_places(stitches));
  problem.remedy = percent > 0 ? "Scale the object to " + std::to_string(percent) +
                                     " % of its size or less, or use wider stitches."
                               : "Choose a machine with more needles, or change the knitting "
                                 "times so that fewer tubes hang side by side.";
  for (int s = step.first_stitch; s <= step.last_stitch; ++s)
    problem.elements.stitches.push_back(s);
  std::vector<int>& nodes = problem.elements.nodes;
  for (const Held& tube : widest)
    for (const LoopStack& stack : *tube.loops)
      for (const LoopName& loop : stack)
        if (loop.stitch >= 0) nodes.push_back(trace.stitches[loop.stitch].node);
  sort_unique(nodes);
  throw NotKnittable({problem});
}

bool is_tight(const SteppedTubes& tubes, const BedOrder& order, const MachineProfile& profile) {
  int turn = 0;
  const std::vector<Held> widest = widest_moment(tubes, order, turn);
  const PlaceRange usable = usable_places(profile);
  return places_for(widest) + 2 * static_cast<int>(widest.size()) >
         usable.highest - usable.lowest + 1;
}

}  // namespace meshknit
