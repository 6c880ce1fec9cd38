#include "meshknit/schedule/schedule_checks.h"

#include <algorithm>
#include <map>
#include <string>
#include <tuple>
#include <utility>

#include "meshknit/schedule/needle_offsets.h"
#include "meshknit/schedule/tube_steps.h"

namespace meshknit {
namespace {

struct HookOrder {
  bool operator()(const Hook& a, const Hook& b) const {
    return std::tie(a.bed, a.n) < std::tie(b.bed, b.n);
  }
};

using Tube = std::map<Hook, LoopStack, HookOrder>;

// What hangs on a hook, and the tube that made it.
struct HangingStack {
  int tube = -1;
  LoopStack loops;
};
using Beds = std::map<Hook, HangingStack, HookOrder>;

bool same(const LoopStack& a, const LoopStack& b) {
  return std::equal(a.begin(), a.end(), b.begin(), b.end(),
                    [](const LoopName& x, const LoopName& y) {
                      return x.stitch == y.stitch && x.which == y.which;
                    });
}

std::string text(const Hook& hook) {
  return std::string(hook.bed == Bed::front ? "front" : "back") + " place " +
         std::to_string(hook.n);
}

class Checker {
 public:
  Checker(const StitchTrace& trace, const Schedule& schedule, const MachineProfile& profile)
      : trace_(trace), schedule_(schedule), highest_(profile.needles / 2 - 1) {}

  Problems run() {
    int stitch = 0;
    size_t end = 0;
    for (size_t i = 0; i < schedule_.steps.size(); ++i) {
      const ScheduleStep& step = schedule_.steps[i];
      if (step.first_stitch != stitch || step.last_stitch < step.first_stitch - 1)
        add("step-order", step.first_stitch, "does not follow the stitch before it");
      stitch = step.last_stitch + 1;
      if (!sizes_agree(step)) {
        add("step-form", step.first_stitch, "begins a step whose lists do not fit together");
        return std::move(problems_);
      }
      take_up(i);
      check_cycle(step.before_hooks, step.first_stitch);
      check_bridges(step);
      if (!decide_direction(step)) continue;
      move(step);
      for (int s = step.first_stitch; s <= step.last_stitch; ++s) make(step, s);
      check_room(step);
      for (auto& [hook, loops] : tube_) beds_[hook] = {step.tube, std::move(loops)};
      for (; end < schedule_.ends.size() && schedule_.ends[end].step == static_cast<int>(i);
           ++end)
        take_off(schedule_.ends[end]);
    }
    if (stitch != static_cast<int>(trace_.stitches.size()))
      add("step-order", stitch, "is in no step");
    if (!beds_.empty() || end < schedule_.ends.size())
      add("step-start", stitch - 1, "leaves other loops than the schedule says");
    return std::move(problems_);
  }

 private:
  void add(const std::string& code, int stitch, const std::string& what) {
    Problem problem;
    problem.code = code;
    problem.message = "Stitch " + std::to_string(stitch) + " " + what + ".";
    problem.remedy = "Please report this object: its schedule is wrong.";
    problem.elements.stitches = {stitch};
    if (stitch >= 0 && stitch < static_cast<int>(trace_.stitches.size()))
      problem.elements.nodes = {trace_.stitches[stitch].node};
    problems_.push_back(std::move(problem));
  }

  bool sizes_agree(const ScheduleStep& step) const {
    if (step.first_stitch < 0 || step.last_stitch < step.first_stitch - 1 ||
        step.last_stitch >= static_cast<int>(trace_.stitches.size()) || step.before.empty())
      return false;
    const auto stitches = static_cast<size_t>(step.last_stitch - step.first_stitch) + 1;
    return std::none_of(step.before.begin(), step.before.end(),
                        [](const LoopStack& stack) { return stack.empty(); }) &&
           step.before.size() == step.before_hooks.size() &&
           step.before.size() == step.moved_hooks.size() &&
           step.stitch_hooks.size() == stitches && step.second_loop_hooks.size() == stitches;
  }

  // The step takes its loops off the beds. A tube takes all that it has, or begins with loops of
  // waste or of other tubes.
  void take_up(size_t i) {
    const ScheduleStep& step = schedule_.steps[i];
    bool good = true;
    int taken_over = -1;  // a tube of which this one takes loops
    const bool cast_on = step.before.front().front().stitch < 0;
    for (size_t stack = 0; stack < step.before.size(); ++stack) {
      const auto found = beds_.find(step.before_hooks[stack]);
      good = good && cast_on == (found == beds_.end());
      if (found == beds_.end()) continue;
      good = good && same(found->second.loops, step.before[stack]);
      if (found->second.tube != step.tube) taken_over = found->second.tube;
      beds_.erase(found);
    }
    if (taken_over >= 0) name_parts(taken_over, i);
    for (const auto& hanging : beds_) good = good && hanging.second.tube != step.tube;
    if (!good)
      add("step-start", step.first_stitch,
          "begins a step on other loops or places than the step before left");
  }

  // What a tube leaves hanging when another takes the first loops of it belongs to the tubes that will
  // take it up: they are tubes of their own from now on.
  void name_parts(int parted, size_t step) {
    for (size_t later = step + 1; later < schedule_.steps.size(); ++later)
      for (const Hook& hook : schedule_.steps[later].before_hooks)
        if (const auto found = beds_.find(hook);
            found != beds_.end() && found->second.tube == parted)
          found->second.tube = schedule_.steps[later].tube;
  }

  void check_bridges(const ScheduleStep& step) {
    std::map<int, std::vector<Hook>> others;  // tube -> its hooks
    for (const auto& [hook, hanging] : beds_) others[hanging.tube].push_back(hook);
    int longest = 1;
    for (const auto& [tube, hooks] : others) longest = std::max(longest, longest_bridge(hooks));
    if (longest == step.bridge_beside) return;
    add("wrong-bridge", step.first_stitch,
        "begins a step beside yarn of " + std::to_string(longest) +
            " needles between the beds, where the schedule says " +
            std::to_string(step.bridge_beside));
  }

  // A place stays free beside tubes that are knit, and the room of a step is its own but for what
  // touches the tube on the other bed, where tubes part or meet.
  void check_room(const ScheduleStep& step) {
    Beds own;
    for (const std::vector<Hook>* hooks : {&step.before_hooks, &step.moved_hooks})
      for (const Hook& hook : *hooks) {
        own[hook] = {};
        if (hook.n < step.lowest_place || hook.n > step.highest_place)
          return add("no-room", step.first_stitch,
                     "needs " + text(hook) + ", which is not in the room of its step");
      }
    for (const Bed bed : {Bed::front, Bed::back}) {
      for (auto other = beds_.lower_bound(Hook{bed, step.lowest_place});
           other != beds_.end() && other->first.bed == bed &&
           other->first.n <= step.highest_place;
           ++other)
        if (own.count(Hook{opposite(bed), other->first.n}) == 0) too_close(step, other->first);
      if (step.last_stitch < step.first_stitch) continue;
      for (const auto& hanging : tube_)
        for (int n = hanging.first.n - kFreeBetween; n <= hanging.first.n + kFreeBetween; ++n)
          if (hanging.first.bed == bed && beds_.count(Hook{bed, n}) > 0)
            return too_close(step, Hook{bed, n});
    }
  }

  void too_close(const ScheduleStep& step, const Hook& other) {
    add("no-room", step.first_stitch,
        "begins a step that comes too close to the tube on " + text(other));
  }

  void take_off(const TubeEnd& end) {
    bool equal = end.loops.size() == end.hooks.size();
    for (size_t i = 0; i < end.hooks.size() && equal; ++i) {
      const auto found = beds_.find(end.hooks[i]);
      equal = found != beds_.end() && found->second.tube == end.tube &&
              same(found->second.loops, end.loops[i]);
      if (equal) beds_.erase(found);
    }
    const int last = schedule_.steps[end.step].last_stitch;
    if (equal)
      check_cycle(end.hooks, last);
    else
      add("step-start", last, "leaves other loops than the schedule says");
  }

  // Hooks of a whole cycle must be one of the layouts: front from left to right, then back from
  // right to left, each bed without gaps, the ends of the beds at most one place apart.
  void check_cycle(const std::vector<Hook>& hooks, int stitch) {
    const size_t n = hooks.size();
    int turns_to_back = 0;
    bool good = n >= 2;
    for (size_t i = 0; i < n && good; ++i) {
      const Hook &here = hooks[i], &next = hooks[(i + 1) % n];
      if (here.n < 1 || here.n > highest_)
        add("off-bed", stitch, "needs " + text(here) + ", which the machine does not have");
      if (here.bed == next.bed) {
        good = next.n - here.n == (here.bed == Bed::front ? 1 : -1);
      } else {
        good = std::abs(next.n - here.n) <= 1;
        turns_to_back += here.bed == Bed::front ? 1 : 0;
      }
    }
    if (!good || turns_to_back != 1)
      add("no-layout", stitch, "begins a step whose loops are not laid out as a tube");
  }

  bool decide_direction(const ScheduleStep& step) {
    if (step.last_stitch < step.first_stitch) return true;
    direction_ = trace_.stitches[step.first_stitch].direction;
    for (int s = step.first_stitch; s <= step.last_stitch; ++s) {
      const Stitch& stitch = trace_.stitches[s];
      if (stitch.direction == direction_ && stitch.tube == step.tube) continue;
      add("step-form", s, "runs against the direction of its step, or is on another tube");
      return false;
    }
    return true;
  }

  // Decreased stacks lie in the order in which the stitches of the step meet them.
  void move(const ScheduleStep& step) {
    tube_.clear();
    const size_t n = step.before.size();
    // Neighbours with one target may sit on both sides of the list's end: begin where two
    // targets differ.
    size_t begin = 0;
    while (begin < n && step.moved_hooks[begin] == step.moved_hooks[(begin + n - 1) % n])
      ++begin;
    for (size_t i = 0; i < n; ++i) {
      const bool forward = direction_ == Direction::anticlockwise;
      const size_t stack = (begin + (forward ? i : 2 * n - 1 - i)) % n;
      LoopStack& target = tube_[step.moved_hooks[stack]];
      target.insert(target.end(), step.before[stack].begin(), step.before[stack].end());
    }
  }

  void make(const ScheduleStep& step, int s) {
    const Stitch& stitch = trace_.stitches[s];
    const Hook hook = step.stitch_hooks[s - step.first_stitch];
    const Hook second = step.second_loop_hooks[s - step.first_stitch];
    const auto found = tube_.find(hook);
    if (found == tube_.end()) {
      add("wrong-parents", s, "is made on " + text(hook) + ", where no loop hangs");
      return;
    }
    if (stitch.kind == StitchKind::tuck) {
      const LoopName below = tucked_loop(trace_, s);
      const bool lies_on_it =
          std::any_of(found->second.begin(), found->second.end(), [&](const LoopName& loop) {
            return loop.stitch == below.stitch && loop.which == below.which;
          });
      if (!lies_on_it) add("wrong-parents", s, "does not lie on the loop that it is tucked on");
      found->second.push_back({s, 0});
      return;
    }
    const LoopStack parents =
        stitch.kind == StitchKind::start ? LoopStack{LoopName{}} : parent_loops(trace_, s);
    if (!same(parents, found->second))
      add("wrong-parents", s,
          "is made on " + text(hook) + " but its parents do not hang there");
    found->second = {{s, 0}};
    if (stitch.kind != StitchKind::increase) {
      if (!(second == hook)) add("step-form", s, "makes one loop but has two hooks");
      return;
    }
    if (tube_.count(second) > 0)
      add("hook-taken", s, "makes its second loop on " + text(second) + ", which is not free");
    tube_[second] = {{s, 1}};
  }

  const StitchTrace& trace_;
  const Schedule& schedule_;
  int highest_;
  Direction direction_ = Direction::anticlockwise;
  Tube tube_;  // the loops of the step
  Beds beds_;  // all others
  Problems problems_;
};

}  // namespace

Problems check_schedule(const StitchTrace& trace, const Schedule& schedule,
                        const MachineProfile& profile) {
  return Checker(trace, schedule, profile).run();
}

}  // namespace meshknit
