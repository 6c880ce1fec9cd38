#include "meshknit/schedule/schedule.h"

#include <algorithm>
#include <string>
#include <utility>

#include "meshknit/core/error.h"
#include "meshknit/schedule/layout_cost.h"
#include "meshknit/schedule/layout_search.h"
#include "meshknit/schedule/needle_offsets.h"
#include "meshknit/schedule/tube_steps.h"

namespace meshknit {
namespace {

void sort_unique(std::vector<int>& nodes) {
  std::sort(nodes.begin(), nodes.end());
  nodes.erase(std::unique(nodes.begin(), nodes.end()), nodes.end());
}

int fewest_places(int slots) { return (slots + 1) / 2; }

void refuse_too_wide(const StitchTrace& trace, const TubeSteps& tube,
                     const MachineProfile& profile) {
  size_t widest = 0;
  for (size_t i = 1; i < tube.steps.size(); ++i)
    if (tube.steps[i].map.slots() > tube.steps[widest].map.slots()) widest = i;
  const int slots = tube.steps[widest].map.slots();
  const PlaceRange usable = usable_places(profile);
  const int places = usable.highest - usable.lowest + 1;
  if (fewest_places(slots) <= places) return;

  const TubeStep& step = tube.steps[widest];
  const std::vector<LoopStack>& hanging =
      widest + 1 < tube.steps.size() ? tube.steps[widest + 1].before : tube.end;
  Problem problem;
  problem.code = "too-wide";
  problem.message = "The widest row has " + std::to_string(slots) +
                    " stitches, but this machine has room for " +
                    std::to_string(std::max(0, 2 * places)) + " round a tube.";
  const int percent = std::max(0, 100 * places / fewest_places(slots));
  problem.remedy = "Scale the object to " + std::to_string(percent) +
                   " % of its size or less, or use wider stitches.";
  for (int s = step.first_stitch; s <= step.last_stitch; ++s)
    problem.elements.stitches.push_back(s);
  std::vector<int>& nodes = problem.elements.nodes;
  for (const LoopStack& stack : hanging)
    for (const LoopName& loop : stack) nodes.push_back(trace.stitches[loop.stitch].node);
  sort_unique(nodes);
  throw NotKnittable({problem});
}

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

void refuse_tall_stacks(const StitchTrace& trace, const TubeSteps& tube,
                        const MachineProfile& profile) {
  Problem problem;
  problem.code = "stack-too-high";
  int tallest = 0;
  for (const TubeStep& step : tube.steps) {
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
  problem.message = "At " + std::to_string(problem.elements.nodes.size()) +
                    " nodes short rows or decreases end on top of each other: up to " +
                    std::to_string(tallest) + " loops on a needle that holds " +
                    std::to_string(profile.max_stack) + ".";
  problem.remedy =
      "Change the knitting times or the stitch size there, so that short rows end further "
      "apart.";
  throw NotKnittable({problem});
}

std::vector<Hook> hooks_of(const BedLayout& layout) {
  std::vector<Hook> hooks;
  hooks.reserve(layout.slots);
  for (int slot = 0; slot < layout.slots; ++slot) hooks.push_back(slot_hook(layout, slot));
  return hooks;
}

ScheduleStep lay_out(TubeStep& step, const BedLayout& before, const BedLayout& after) {
  ScheduleStep result;
  result.first_stitch = step.first_stitch;
  result.last_stitch = step.last_stitch;
  result.before = std::move(step.before);
  result.before_hooks = hooks_of(before);
  for (int stack = 0; stack < step.map.stacks(); ++stack)
    result.moved_hooks.push_back(slot_hook(after, step.map.slot_of(stack) % step.map.slots()));
  for (const int slot : step.stitch_slot) result.stitch_hooks.push_back(slot_hook(after, slot));
  for (const int slot : step.second_slot)
    result.second_loop_hooks.push_back(slot_hook(after, slot));
  return result;
}

}  // namespace

Schedule schedule_stitches(const StitchTrace& trace, const MachineProfile& profile,
                           RunContext* run) {
  Schedule schedule;
  if (trace.stitches.empty()) return schedule;
  TubeSteps tube = replay_tube(trace);
  refuse_too_wide(trace, tube, profile);
  refuse_tall_stacks(trace, tube, profile);

  // A step that neither increases nor decreases keeps the layout of the step before. That loses
  // nothing: rolls and shifts of one move are never more than those of the same move made in
  // parts.
  std::vector<SlotMap> maps;
  for (const TubeStep& step : tube.steps)
    if (!step.map.is_identity()) maps.push_back(step.map);
  std::vector<BedLayout> layouts = search_layouts(tube.steps.front().map.stacks(), maps, run);
  schedule.optimal = place_layouts(layouts, maps, profile);

  ShiftMeter meter;
  size_t now = 0;
  for (TubeStep& step : tube.steps) {
    const size_t before = now;
    if (!step.map.is_identity()) {
      ++now;
      schedule.cost.roll += count_rolls(step.map, layouts[before], layouts[now]);
      const int offset = layouts[now].place - layouts[before].place;
      schedule.cost.shift +=
          meter.measure(step.map, layouts[before], layouts[now], {offset, offset, offset})
              .shift;
    }
    schedule.cost.alignment += is_aligned(layouts[now]) ? 0 : 1;
    schedule.steps.push_back(lay_out(step, layouts[before], layouts[now]));
  }
  schedule.end = std::move(tube.end);
  schedule.end_hooks = hooks_of(layouts.back());
  report(run, 1.0);
  return schedule;
}

}  // namespace meshknit
