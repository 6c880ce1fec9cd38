#include "meshknit/schedule/tube_steps.h"

#include <algorithm>
#include <array>
#include <string>
#include <utility>

#include "meshknit/core/error.h"

namespace meshknit {
namespace {

enum class Work { none, knit, joined, tuck };  // joined: the second stack of a decrease

[[noreturn]] void refuse(const StitchTrace& trace, const std::string& code, int stitch,
                         std::string message, std::string remedy) {
  Problem problem;
  problem.code = code;
  problem.message = std::move(message);
  problem.remedy = std::move(remedy);
  problem.elements.stitches = {stitch};
  problem.elements.nodes = {trace.stitches[stitch].node};
  throw NotKnittable({problem});
}

[[noreturn]] void refuse_tubes(const StitchTrace& trace, int stitch, const std::string& what) {
  refuse(
      trace, "needs-one-tube", stitch, what,
      "Shape the object as one tube from one opening to another, without branches or handles.");
}

class TubeReplay {
 public:
  explicit TubeReplay(const StitchTrace& trace)
      : trace_(trace), place_(trace.stitches.size(), {-1, -1}) {}

  TubeSteps run() {
    begin_ring();
    TubeSteps result;
    while (cursor_ < static_cast<int>(trace_.stitches.size()))
      result.steps.push_back(next_step());
    result.end = std::move(ring_);
    return result;
  }

 private:
  // The stacks that a stitch works, in its own direction; empty if some loop does not hang in
  // the ring.
  std::vector<int> stacks_of(int stitch) const {
    const Stitch& s = trace_.stitches[stitch];
    if (s.kind == StitchKind::start) {
      const bool forward = s.direction == Direction::anticlockwise;
      return {forward ? stitch : size() - 1 - stitch};
    }
    const std::vector<LoopName> loops = s.kind == StitchKind::tuck
                                            ? std::vector<LoopName>{tucked_loop(trace_, stitch)}
                                            : parent_loops(trace_, stitch);
    std::vector<int> stacks;
    for (const LoopName& loop : loops) {
      const int stack = loop.stitch < 0 ? -1 : place_[loop.stitch][loop.which];
      if (stack < 0) return {};
      if (stacks.empty() || stacks.back() != stack) stacks.push_back(stack);
    }
    return stacks;
  }

  int size() const { return static_cast<int>(ring_.size()); }

  void begin_ring() {
    const std::vector<Stitch>& stitches = trace_.stitches;
    size_t starts = 0;
    while (starts < stitches.size() && stitches[starts].kind == StitchKind::start) ++starts;
    for (size_t s = 0; s < stitches.size(); ++s) {
      const bool start = stitches[s].kind == StitchKind::start;
      if (stitches[s].yarn != stitches.front().yarn)
        refuse_tubes(trace_, static_cast<int>(s),
                     "The object needs a second yarn, from stitch " + std::to_string(s) +
                         " on; only one tube of one yarn can be scheduled.");
      if (start && (s >= starts || stitches[s].direction != stitches.front().direction))
        refuse_tubes(trace_, static_cast<int>(s),
                     "Another tube begins at stitch " + std::to_string(s) +
                         "; only one tube can be scheduled.");
    }
    ring_.assign(starts, LoopStack{LoopName{}});
    check_width(0);
  }

  void check_width(int stitch) const {
    if (size() >= 2 || trace_.stitches.empty()) return;
    refuse(trace_, "too-narrow", stitch,
           "At stitch " + std::to_string(stitch) + " the tube has fewer than two loops.",
           "Make the object larger or its openings wider, so that every row has at least two "
           "stitches.");
  }

  // True if the stitch may join the step; throws if it could not even begin one.
  bool claim(int stitch, bool first_of_step) {
    const Stitch& s = trace_.stitches[stitch];
    const std::vector<int> stacks = stacks_of(stitch);
    bool free = !stacks.empty();
    for (const int stack : stacks) free = free && work_[stack] == Work::none;
    if (!free) {
      if (first_of_step)
        refuse_tubes(trace_, stitch,
                     "Stitch " + std::to_string(stitch) +
                         " would be knit through loops that do not hang on the machine.");
      return false;
    }
    check_stacks(stitch, stacks);
    if (s.kind == StitchKind::tuck) {
      work_[stacks[0]] = Work::tuck;
    } else {
      work_[stacks[0]] = Work::knit;
      if (stacks.size() == 2) work_[stacks[1]] = Work::joined;
    }
    for (const int stack : stacks) worker_[stack] = stitch;
    return true;
  }

  void check_stacks(int stitch, const std::vector<int>& stacks) const {
    const Stitch& s = trace_.stitches[stitch];
    if (s.kind == StitchKind::start) return;
    const int ahead = s.direction == Direction::anticlockwise ? 1 : size() - 1;
    bool good =
        stacks.size() == 1 || (stacks.size() == 2 && (stacks[0] + ahead) % size() == stacks[1]);
    if (good && s.kind != StitchKind::tuck) {
      LoopStack hanging;
      for (const int stack : stacks)
        hanging.insert(hanging.end(), ring_[stack].begin(), ring_[stack].end());
      const std::vector<LoopName> wanted = parent_loops(trace_, stitch);
      good = hanging.size() == wanted.size() &&
             std::equal(hanging.begin(), hanging.end(), wanted.begin(),
                        [](const LoopName& a, const LoopName& b) {
                          return a.stitch == b.stitch && a.which == b.which;
                        });
    }
    if (!good)
      refuse_tubes(trace_, stitch,
                   "The parents of stitch " + std::to_string(stitch) +
                       " do not hang side by side on the tube.");
  }

  TubeStep next_step() {
    work_.assign(ring_.size(), Work::none);
    worker_.assign(ring_.size(), -1);
    TubeStep step;
    step.first_stitch = cursor_;
    const int stitches = static_cast<int>(trace_.stitches.size());
    const Direction direction = trace_.stitches[cursor_].direction;
    while (cursor_ < stitches && trace_.stitches[cursor_].direction == direction &&
           claim(cursor_, cursor_ == step.first_stitch))
      ++cursor_;
    step.last_stitch = cursor_ - 1;
    make_slots(step);
    check_width(step.last_stitch);
    return step;
  }

  // Walks round the tube once, giving out slots, and hangs the new loops into the next ring.
  void make_slots(TubeStep& step) {
    const int n = size(), count = step.last_stitch - step.first_stitch + 1;
    const bool forward =
        trace_.stitches[step.first_stitch].direction == Direction::anticlockwise;
    step.stitch_slot.assign(count, -1);
    step.second_slot.assign(count, -1);
    std::vector<int> slot_of_stack(n);
    std::vector<LoopStack> next;
    const auto gap = [&](int stitch) {
      step.second_slot[stitch - step.first_stitch] = static_cast<int>(next.size());
      next.push_back({LoopName{stitch, 1}});
    };
    // The later stack of a decrease takes the slot of the earlier one; at the seam that is the
    // last slot, one turn on.
    const auto joins_previous = [&](int stack) {
      const int previous = (stack + n - 1) % n;
      return worker_[stack] >= 0 && worker_[stack] == worker_[previous] && n > 1;
    };
    const bool seam_joined = joins_previous(0);
    for (int stack = 0; stack < n; ++stack) {
      const int stitch = worker_[stack];
      const bool doubled = stitch >= 0 &&
                           trace_.stitches[stitch].kind == StitchKind::increase &&
                           work_[stack] == Work::knit;
      if (doubled && !forward) gap(stitch);
      if (stack == n - 1 && seam_joined) {
        slot_of_stack[stack] = static_cast<int>(next.size());
        break;
      }
      if (stack == 0 || !joins_previous(stack)) {
        next.push_back(ring_[stack]);
        if (work_[stack] == Work::knit || work_[stack] == Work::joined)
          next.back() = {LoopName{stitch, 0}};
        else if (work_[stack] == Work::tuck)
          next.back().push_back({stitch, 0});
      }
      slot_of_stack[stack] = static_cast<int>(next.size()) - 1;
      if (stitch >= 0) step.stitch_slot[stitch - step.first_stitch] = slot_of_stack[stack];
      if (doubled && forward) gap(stitch);
    }
    for (int k = 0; k < count; ++k)
      if (step.second_slot[k] < 0) step.second_slot[k] = step.stitch_slot[k];
    step.map = SlotMap(std::move(slot_of_stack), static_cast<int>(next.size()));
    hang(std::move(next), step);
  }

  void hang(std::vector<LoopStack> next, TubeStep& step) {
    for (const LoopStack& stack : ring_)
      for (const LoopName& loop : stack)
        if (loop.stitch >= 0) place_[loop.stitch][loop.which] = -1;
    step.before = std::move(ring_);
    ring_ = std::move(next);
    for (int stack = 0; stack < size(); ++stack)
      for (const LoopName& loop : ring_[stack])
        if (loop.stitch >= 0) place_[loop.stitch][loop.which] = stack;
  }

  const StitchTrace& trace_;
  std::vector<std::array<int, 2>>
      place_;  // of every loop: its stack in the ring, -1 if it does not hang there
  std::vector<LoopStack> ring_;
  std::vector<Work> work_;
  std::vector<int> worker_;  // stitch that works a stack in the current step
  int cursor_ = 0;
};

}  // namespace

TubeSteps replay_tube(const StitchTrace& trace) { return TubeReplay(trace).run(); }

}  // namespace meshknit
