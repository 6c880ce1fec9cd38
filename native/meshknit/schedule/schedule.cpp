#include "meshknit/schedule/schedule.h"

#include <utility>

#include "meshknit/schedule/bed_order.h"
#include "meshknit/schedule/connections.h"
#include "meshknit/schedule/layout_cost.h"
#include "meshknit/schedule/needle_offsets.h"
#include "meshknit/schedule/room_on_bed.h"
#include "meshknit/schedule/tube_layouts.h"
#include "meshknit/schedule/tube_steps.h"

namespace meshknit {
namespace {

std::vector<Hook> hooks_of(const BedLayout& layout) {
  std::vector<Hook> hooks;
  hooks.reserve(layout.slots);
  for (int slot = 0; slot < layout.slots; ++slot) hooks.push_back(slot_hook(layout, slot));
  return hooks;
}

// What a tube holds before a step; after its last one for step == size.
const std::vector<LoopStack>& hanging_before(const TubeSteps& tube, int step) {
  return step < static_cast<int>(tube.steps.size()) ? tube.steps[step].before : tube.end;
}

ScheduleStep lay_out(const TubeStep& step, const BedLayout& after) {
  ScheduleStep result;
  result.first_stitch = step.first_stitch;
  result.last_stitch = step.last_stitch;
  for (int stack = 0; stack < step.map.stacks(); ++stack)
    result.moved_hooks.push_back(slot_hook(after, step.map.slot_of(stack) % step.map.slots()));
  for (const int slot : step.stitch_slot) result.stitch_hooks.push_back(slot_hook(after, slot));
  for (const int slot : step.second_slot)
    result.second_loop_hooks.push_back(slot_hook(after, slot));
  return result;
}

class Assembly {
 public:
  explicit Assembly(const SteppedTubes& tubes) : tubes_(tubes), done_(tubes.tubes.size(), 0) {}

  void add(const PlacedStep& placed) {
    const TubeSteps& tube = tubes_.tubes[placed.tube];
    const bool moves_only = placed.step < 0;
    ScheduleStep step;
    if (moves_only) {
      step.first_stitch = next_stitch_;
      step.last_stitch = next_stitch_ - 1;
      step.moved_hooks = hooks_of(placed.after);
    } else {
      step = lay_out(tube.steps[placed.step], placed.after);
      next_stitch_ = step.last_stitch + 1;
    }
    step.tube = placed.tube;
    step.before = hanging_before(tube, done_[placed.tube]);
    step.before_hooks = hooks_of(placed.before);
    step.lowest_place = placed.room.lowest;
    step.highest_place = placed.room.highest;
    step.bridge_beside = placed.bridge_beside;
    schedule_.steps.push_back(std::move(step));
    count_cost(placed);
    if (moves_only) return;
    ++done_[placed.tube];
    if (done_[placed.tube] == static_cast<int>(tube.steps.size()) && tube.above.empty())
      schedule_.ends.push_back({placed.tube, static_cast<int>(schedule_.steps.size()) - 1,
                                tube.end, hooks_of(placed.after)});
  }

  Schedule take() { return std::move(schedule_); }

 private:
  void count_cost(const PlacedStep& placed) {
    LayoutCost& cost = schedule_.cost;
    const int offset = placed.after.place - placed.before.place;
    if (placed.step < 0) {
      cost.shift += placed.after.slots;
      return;
    }
    const SlotMap& map = tubes_.tubes[placed.tube].steps[placed.step].map;
    cost.alignment += is_aligned(placed.after) ? 0 : 1;
    cost.roll += count_rolls(map, placed.before, placed.after);
    cost.shift +=
        meter_.measure(map, placed.before, placed.after, {offset, offset, offset}).shift;
  }

  const SteppedTubes& tubes_;
  std::vector<int> done_;  // [tube] steps
  int next_stitch_ = 0;
  MoveMeter meter_;
  Schedule schedule_;
};

}  // namespace

Schedule schedule_stitches(const StitchTrace& trace, const MachineProfile& profile,
                           RunContext* run) {
  if (trace.stitches.empty()) return {};
  const SteppedTubes tubes = replay_tubes(trace);
  refuse_tall_stacks(trace, tubes, profile);
  const std::vector<Connection> connections = find_connections(trace, tubes);

  LayoutChoices choices(tubes, connections);
  const BedOrder order = choose_order(trace, tubes, connections, choices.costs(run));
  refuse_too_wide(trace, tubes, order, profile);
  const bool tight = is_tight(tubes, order, profile);
  const std::vector<TubeLayouts> layouts = choices.layouts(order, tight, run);
  const PlacedTubes placed = place_tubes(tubes, connections, order, layouts, profile);

  Assembly assembly(tubes);
  for (const PlacedStep& step : placed.steps) assembly.add(step);
  Schedule schedule = assembly.take();
  schedule.optimal_order = order.optimal;
  schedule.optimal_moves = placed.optimal;
  schedule.segments = static_cast<int>(tubes.tubes.size());
  schedule.connections = static_cast<int>(connections.size());
  report(run, 1.0);
  return schedule;
}

}  // namespace meshknit
