#include "meshknit/schedule/schedule_checks.h"

#include <algorithm>
#include <map>
#include <string>
#include <tuple>
#include <utility>

#include "meshknit/schedule/tube_steps.h"

namespace meshknit {
namespace {

struct HookOrder {
  bool operator()(const Hook& a, const Hook& b) const {
    return std::tie(a.bed, a.n) < std::tie(b.bed, b.n);
  }
};

using Tube = std::map<Hook, LoopStack, HookOrder>;

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
    for (const ScheduleStep& step : schedule_.steps) {
      if (step.first_stitch != stitch || step.last_stitch < step.first_stitch)
        add("step-order", step.first_stitch, "does not follow the stitch before it");
      stitch = step.last_stitch + 1;
      if (!sizes_agree(step)) {
        add("step-form", step.first_stitch, "begins a step whose lists do not fit together");
        return std::move(problems_);
      }
      check_start(step);
      check_cycle(step.before_hooks, step.first_stitch);
      if (!decide_direction(step)) continue;
      move(step);
      for (int s = step.first_stitch; s <= step.last_stitch; ++s) make(step, s);
    }
    if (stitch != static_cast<int>(trace_.stitches.size()))
      add("step-order", stitch, "is in no step");
    check_end();
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
    const size_t stitches = static_cast<size_t>(step.last_stitch - step.first_stitch + 1);
    return step.first_stitch >= 0 &&
           step.last_stitch < static_cast<int>(trace_.stitches.size()) &&
           step.before.size() == step.before_hooks.size() &&
           step.before.size() == step.moved_hooks.size() &&
           step.stitch_hooks.size() == stitches && step.second_loop_hooks.size() == stitches;
  }

  void check_start(const ScheduleStep& step) {
    if (&step == &schedule_.steps.front()) return;
    Tube before;
    for (size_t i = 0; i < step.before.size(); ++i)
      before[step.before_hooks[i]] = step.before[i];
    const bool equal = before.size() == tube_.size() &&
                       std::equal(before.begin(), before.end(), tube_.begin(),
                                  [](const auto& a, const auto& b) {
                                    return a.first == b.first && same(a.second, b.second);
                                  });
    if (!equal)
      add("step-start", step.first_stitch,
          "begins a step on other loops or places than the step before left");
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
    direction_ = trace_.stitches[step.first_stitch].direction;
    for (int s = step.first_stitch; s <= step.last_stitch; ++s)
      if (trace_.stitches[s].direction != direction_) {
        add("step-form", s, "runs against the direction of its step");
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

  void check_end() {
    if (schedule_.steps.empty()) return;
    bool equal = schedule_.end.size() == tube_.size() &&
                 schedule_.end.size() == schedule_.end_hooks.size();
    for (size_t i = 0; i < schedule_.end.size() && equal; ++i) {
      const auto found = tube_.find(schedule_.end_hooks[i]);
      equal = found != tube_.end() && same(found->second, schedule_.end[i]);
    }
    const int last = schedule_.steps.back().last_stitch;
    if (equal)
      check_cycle(schedule_.end_hooks, last);
    else
      add("step-start", last, "leaves other loops than the schedule says");
  }

  const StitchTrace& trace_;
  const Schedule& schedule_;
  int highest_;
  Direction direction_ = Direction::anticlockwise;
  Tube tube_;
  Problems problems_;
};

}  // namespace

Problems check_schedule(const StitchTrace& trace, const Schedule& schedule,
                        const MachineProfile& profile) {
  return Checker(trace, schedule, profile).run();
}

}  // namespace meshknit
