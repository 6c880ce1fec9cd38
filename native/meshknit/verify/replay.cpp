#include "meshknit/verify/replay.h"

#include <algorithm>
#include <string>
#include <utility>

#include "meshknit/verify/beds.h"
#include "meshknit/verify/carrier_rules.h"
#include "meshknit/verify/machine_rules.h"
#include "meshknit/verify/yarn_slack.h"

namespace meshknit {
namespace {

using Stack = std::vector<int>;  // loops, earliest arrival first

class Replay {
 public:
  Replay(const Program& program, const MachineProfile& profile, ProblemLog& log)
      : profile_(profile),
        log_(log),
        beds_(program, profile, {}),
        carriers_(profile, fabric_, log),
        slack_(fabric_, profile, log) {}

  void run(const Instruction& i) {
    switch (i.op) {
      case Op::in:
      case Op::inhook:
        return carriers_.bring_in(i);
      case Op::out:
      case Op::outhook:
        return carriers_.take_out(i);
      case Op::releasehook:
        return carriers_.release(i);
      case Op::rack:
        racking_ = check_racking(i, profile_, log_);
        return slack_.racked(racking_, i.line);
      case Op::knit:
      case Op::tuck:
        return make_loop(i);
      case Op::split:
        hand_over(i);
        return make_loop(i);
      case Op::xfer:
        return hand_over(i);
      case Op::drop:
        return drop(i);
      case Op::miss:
        check_needle(i.needle, i.line, beds_, profile_, log_);
        return carriers_.pass_by(i);
      case Op::amiss:
        check_needle(i.needle, i.line, beds_, profile_, log_);
        return;
      case Op::extension:
        return check_setting(i, profile_, log_);
      case Op::pause:
        return;
    }
  }

  Fabric finish() {
    carriers_.finish();
    for (const Loop& loop : fabric_.loops) {
      if (loop.fate != Loop::Fate::held) continue;
      log_.error("loops-left", loop.line,
                 "the loop made here still hangs on " + to_string(loop.hangs_on) +
                     " at the end of the file",
                 {named_stitch(loop)});
    }
    return std::move(fabric_);
  }

 private:
  void make_loop(const Instruction& i) {
    if (!check_needle(i.needle, i.line, beds_, profile_, log_)) return;
    if (i.needle.slider) {
      log_.error("stitch-on-slider", i.line,
                 "no loop can be made on a slider: " + to_string(i.needle));
    }
    const int position =
        kQuarters * i.needle.index + (i.needle.bed == Bed::back ? racking_ : 0);
    const int id = add_loop(i, carriers_.use(i, position));
    Loop& loop = fabric_.loops[id];
    Stack& stack = beds_.at(i.needle);
    if (i.op == Op::tuck) {
      loop.below = static_cast<int>(stack.size());
    } else if (i.op == Op::knit) {
      if (stack.empty() && is_object(loop)) {
        log_.error("knit-on-empty", i.line,
                   "a stitch is knit on " + to_string(i.needle) + ", which holds no loop",
                   {named_stitch(loop)});
      }
      knit_through(stack, id);
    } else {
      pull_through_moved(i, id);
    }
    stack.push_back(id);
    check_height(i.needle, i.line);
    slack_.made(id, racking_);
  }

  int add_loop(const Instruction& i, int yarn) {
    const int id = static_cast<int>(fabric_.loops.size());
    Loop loop;
    loop.yarn = yarn;
    std::vector<int>& on_yarn = fabric_.yarns[yarn].loops;
    if (!on_yarn.empty()) {
      loop.previous = on_yarn.back();
      fabric_.loops[loop.previous].following = id;
    }
    on_yarn.push_back(id);
    loop.line = i.line;
    loop.made_by = i.op;
    loop.direction = i.direction;
    loop.made_on = loop.hangs_on = i.needle;
    loop.source = i.source;
    loop.first_parent = static_cast<int>(fabric_.parents.size());
    fabric_.loops.push_back(loop);
    return id;
  }

  void knit_through(Stack& stack, int child) {
    for (const int parent : stack) {
      link(parent, child);
      fabric_.loops[parent].fate = Loop::Fate::knit_through;
      fabric_.loops[parent].fate_line = fabric_.loops[child].line;
      slack_.let_go(parent);
    }
    stack.clear();
  }

  // Split: the loops that went over to the target stay alive there.
  void pull_through_moved(const Instruction& i, int child) {
    for (const int parent : std::exchange(handed_over_, {})) link(parent, child);
    if (fabric_.loops[child].parents == 0 && is_object(fabric_.loops[child])) {
      log_.error("knit-on-empty", i.line,
                 "a stitch is split on " + to_string(i.needle) + ", which holds no loop",
                 {named_stitch(fabric_.loops[child])});
    }
  }

  void link(int parent, int child) {
    fabric_.parents.push_back(parent);
    ++fabric_.loops[child].parents;
    if (fabric_.loops[parent].child < 0) fabric_.loops[parent].child = child;
  }

  void hand_over(const Instruction& i) {
    handed_over_.clear();
    const bool known = check_needle(i.needle, i.line, beds_, profile_, log_) &&
                       check_needle(i.target, i.line, beds_, profile_, log_);
    if (!known || i.needle == i.target) {
      if (known) check_handover(i, racking_, log_);
      return;
    }
    check_handover(i, racking_, log_);
    carriers_.before_transfer(i.line);
    Stack& from = beds_.at(i.needle);
    Stack& to = beds_.at(i.target);
    if (from.empty()) {
      if (i.op == Op::xfer) {
        log_.error("transfer-from-empty", i.line,
                   to_string(i.needle) + " holds no loop to move");
      }
      return;
    }
    if (i.target.slider && !to.empty()) {
      log_.error("slider-stack", i.line,
                 to_string(i.target) + " holds a loop already; a slider has room for one");
    }
    handed_over_ = std::exchange(from, {});
    for (const int loop : handed_over_) {
      fabric_.loops[loop].hangs_on = i.target;
      to.push_back(loop);
    }
    check_height(i.target, i.line);
    for (const int loop : handed_over_) slack_.moved(loop, racking_, i.line);
  }

  void drop(const Instruction& i) {
    if (!check_needle(i.needle, i.line, beds_, profile_, log_)) return;
    Stack& stack = beds_.at(i.needle);
    if (stack.empty()) {
      log_.warning("drop-from-empty", i.line, to_string(i.needle) + " holds no loop to drop");
      return;
    }
    for (const int loop : stack) {
      fabric_.loops[loop].fate = Loop::Fate::dropped;
      fabric_.loops[loop].fate_line = i.line;
      slack_.let_go(loop);
    }
    stack.clear();
  }

  void check_height(const Needle& needle, int line) {
    const std::vector<int>& loops = beds_.at(needle);
    const int height = static_cast<int>(loops.size());
    fabric_.max_stack = std::max(fabric_.max_stack, height);
    if (height < profile_.max_stack) return;
    std::vector<int> stitches;
    for (const int loop : loops) stitches.push_back(named_stitch(fabric_.loops[loop]));
    const std::string text = to_string(needle) + " holds " + std::to_string(height) + " loops";
    const std::string remedy = "Spread decreases and short rows further apart here.";
    if (height > profile_.max_stack) {
      log_.error("stack-too-high", line, text, stitches, remedy);
    } else {
      log_.warning("stack-high", line, text, stitches, remedy);
    }
  }

  const MachineProfile& profile_;
  ProblemLog& log_;
  Fabric fabric_;
  Beds<Stack> beds_;
  CarrierRules carriers_;
  YarnSlack slack_;
  std::vector<int> handed_over_;  // by the last transfer, for a split's new loop
  int racking_ = 0;               // quarter needles
};

}  // namespace

Fabric replay_program(const Program& program, const MachineProfile& profile, ProblemLog& log,
                      RunContext* run) {
  Replay replay(program, profile, log);
  constexpr std::size_t kBetweenReports = 4096;
  const std::size_t count = program.instructions.size();
  for (std::size_t k = 0; k < count; ++k) {
    if (k % kBetweenReports == 0) {
      report(run, 0.5 * static_cast<double>(k) / static_cast<double>(count));
    }
    replay.run(program.instructions[k]);
  }
  return replay.finish();
}

}  // namespace meshknit
