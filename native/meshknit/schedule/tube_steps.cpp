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

[[noreturn]] void refuse_apart(const StitchTrace& trace, int stitch) {
  refuse(trace, "loops-apart", stitch,
         "The loops that stitch " + std::to_string(stitch) +
             " is knit through do not hang side by side on its tube.",
         "Smooth the object there, or change its knitting times so that tubes part and meet "
         "further from each other.");
}

class TubeReplay {
 public:
  explicit TubeReplay(const StitchTrace& trace)
      : trace_(trace), place_(trace.stitches.size()), rings_(trace.tubes) {}

  SteppedTubes run() {
    result_.tubes.resize(rings_.size());
    while (cursor_ < static_cast<int>(trace_.stitches.size())) {
      tube_ = trace_.stitches[cursor_].tube;
      ring_ = std::move(rings_[tube_]);
      TubeSteps& tube = result_.tubes[tube_];
      if (tube.steps.empty()) begin_ring(tube);
      result_.turns.push_back({tube_, static_cast<int>(tube.steps.size())});
      tube.steps.push_back(next_step());
      rings_[tube_] = std::move(ring_);
    }
    for (size_t t = 0; t < rings_.size(); ++t)
      if (result_.tubes[t].above.empty()) result_.tubes[t].end = std::move(rings_[t]);
    return std::move(result_);
  }

 private:
  // A loop's stack in the ring of a tube; -1 where it hangs no more.
  struct LoopPlace {
    int tube = -1, stack = -1;
  };

  // The stacks that a stitch works, in its own direction; empty if some loop does not hang in
  // the ring.
  std::vector<int> stacks_of(int stitch) const {
    const Stitch& s = trace_.stitches[stitch];
    if (s.kind == StitchKind::start) {
      const int turn = stitch - begun_with_;
      if (turn >= size()) return {};
      return {s.direction == Direction::anticlockwise ? turn : size() - 1 - turn};
    }
    const std::vector<LoopName> loops = s.kind == StitchKind::tuck
                                            ? std::vector<LoopName>{tucked_loop(trace_, stitch)}
                                            : parent_loops(trace_, stitch);
    std::vector<int> stacks;
    for (const LoopName& loop : loops) {
      const LoopPlace at = loop.stitch < 0 ? LoopPlace{} : place_[loop.stitch][loop.which];
      if (at.tube != tube_ || at.stack < 0) return {};
      if (stacks.empty() || stacks.back() != at.stack) stacks.push_back(at.stack);
    }
    return stacks;
  }

  int size() const { return static_cast<int>(ring_.size()); }

  void begin_ring(TubeSteps& tube) {
    begun_with_ = cursor_;
    if (trace_.stitches[cursor_].kind == StitchKind::start)
      cast_on();
    else
      take_over(tube);
    check_width(cursor_);
  }

  void cast_on() {
    int end = cursor_;
    const auto goes_on = [&](int s) {
      const Stitch &first = trace_.stitches[cursor_], &stitch = trace_.stitches[s];
      return stitch.kind == StitchKind::start && stitch.tube == tube_ &&
             stitch.direction == first.direction;
    };
    while (end < static_cast<int>(trace_.stitches.size()) && goes_on(end)) ++end;
    ring_.assign(end - cursor_, LoopStack{LoopName{}});
  }

  // The first round of a tube goes over all loops that it takes from others.
  void take_over(TubeSteps& tube) {
    for (int s = cursor_; s < static_cast<int>(trace_.stitches.size()); ++s) {
      if (trace_.stitches[s].tube != tube_) break;
      const std::vector<LoopName> loops = parent_loops(trace_, s);
      if (loops.empty() || trace_.stitches[loops[0].stitch].tube == tube_) break;
      for (const LoopName& loop : loops) {
        const LoopPlace at = place_[loop.stitch][loop.which];
        if (at.stack < 0) refuse_apart(trace_, s);
        const EndStack last = tube.origins.empty() ? EndStack{} : tube.origins.back();
        if (at.tube != last.tube || at.stack != last.stack)
          tube.origins.push_back({at.tube, at.stack});
      }
    }
    if (trace_.stitches[cursor_].direction == Direction::clockwise)
      std::reverse(tube.origins.begin(), tube.origins.end());
    for (const EndStack& origin : tube.origins) {
      TubeSteps& below = result_.tubes[origin.tube];
      if (std::find(below.above.begin(), below.above.end(), tube_) == below.above.end()) {
        if (below.above.empty()) below.end = rings_[origin.tube];
        below.above.push_back(tube_);
        tube.below.push_back(origin.tube);
      }
      ring_.push_back(below.end[origin.stack]);
    }
    remember_places();
  }

  void remember_places() {
    for (int stack = 0; stack < size(); ++stack)
      for (const LoopName& loop : ring_[stack])
        if (loop.stitch >= 0) place_[loop.stitch][loop.which] = {tube_, stack};
  }

  void check_width(int stitch) const {
    if (size() >= 2) return;
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
      if (first_of_step) refuse_apart(trace_, stitch);
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
    if (!good) refuse_apart(trace_, stitch);
  }

  TubeStep next_step() {
    work_.assign(ring_.size(), Work::none);
    worker_.assign(ring_.size(), -1);
    TubeStep step;
    step.first_stitch = cursor_;
    const int stitches = static_cast<int>(trace_.stitches.size());
    const Direction direction = trace_.stitches[cursor_].direction;
    while (cursor_ < stitches && trace_.stitches[cursor_].direction == direction &&
           trace_.stitches[cursor_].tube == tube_ &&
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
    const Direction direction = trace_.stitches[step.first_stitch].direction;
    const bool forward = direction == Direction::anticlockwise;
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
    step.map = SlotMap(std::move(slot_of_stack), static_cast<int>(next.size()), direction);
    hang(std::move(next), step);
  }

  void hang(std::vector<LoopStack> next, TubeStep& step) {
    for (const LoopStack& stack : ring_)
      for (const LoopName& loop : stack)
        if (loop.stitch >= 0) place_[loop.stitch][loop.which] = {};
    step.before = std::move(ring_);
    ring_ = std::move(next);
    remember_places();
  }

  const StitchTrace& trace_;
  SteppedTubes result_;
  std::vector<std::array<LoopPlace, 2>> place_;  // of every loop
  std::vector<std::vector<LoopStack>> rings_;    // of tubes that wait
  // The tube that is being worked.
  int tube_ = 0;
  std::vector<LoopStack> ring_;
  std::vector<Work> work_;
  std::vector<int> worker_;  // stitch that works a stack in the current step
  int begun_with_ = 0;       // its first stitch
  int cursor_ = 0;
};

}  // namespace

SteppedTubes replay_tubes(const StitchTrace& trace) { return TubeReplay(trace).run(); }

}  // namespace meshknit
