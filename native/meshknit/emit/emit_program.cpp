#include "meshknit/emit/emit_program.h"

#include <algorithm>
#include <string>
#include <utility>

#include "meshknit/core/error.h"
#include "meshknit/emit/carriers.h"
#include "meshknit/emit/program_builder.h"
#include "meshknit/emit/step_transfers.h"
#include "meshknit/emit/waste_yarn.h"
#include "meshknit/emit/yarn_ends.h"

namespace meshknit {
namespace {

constexpr int kAnchoredSteps = 2;  // a yarn end holds by itself after two rounds

Program header(const MachineProfile& profile) {
  Program program;
  program.carriers = profile.carriers;
  if (!profile.machine_header.empty())
    program.headers.emplace_back("Machine", profile.machine_header);
  program.headers.emplace_back("Gauge", std::to_string(profile.gauge));
  // Needles are used as written: the schedule has centred the tube and checked that it fits.
  program.headers.emplace_back("Position", "Keep");
  for (const std::string& setting : profile.first_settings) {
    Instruction instruction;
    instruction.op = Op::extension;
    instruction.text = setting;
    program.instructions.push_back(std::move(instruction));
  }
  return program;
}

[[noreturn]] void refuse_transfers(const StitchTrace& trace, const ScheduleStep& step) {
  Problem problem;
  problem.code = "transfer-impossible";
  problem.message = "The loops cannot be moved to where the row that begins with stitch " +
                    std::to_string(step.first_stitch) + " needs them.";
  problem.remedy = "Make the width of the object change more slowly there.";
  for (size_t i = 0; i < step.before.size(); ++i) {
    if (step.before_hooks[i] == step.moved_hooks[i]) continue;
    for (const LoopName& loop : step.before[i]) {
      if (loop.stitch < 0) continue;  // waste
      problem.elements.stitches.push_back(loop.stitch);
      problem.elements.nodes.push_back(trace.stitches[loop.stitch].node);
    }
  }
  std::vector<int>& nodes = problem.elements.nodes;
  std::sort(nodes.begin(), nodes.end());
  nodes.erase(std::unique(nodes.begin(), nodes.end()), nodes.end());
  throw NotKnittable({problem});
}

class Emitter {
 public:
  Emitter(const StitchTrace& trace, const Schedule& schedule, const MachineProfile& profile)
      : trace_(trace),
        schedule_(schedule),
        profile_(profile),
        yarns_(assign_carriers(trace, profile)),
        program_(header(profile)) {}

  Program run(RunContext* run) {
    const std::vector<ScheduleStep>& steps = schedule_.steps;
    auto end = schedule_.ends.begin();
    for (size_t i = 0; i < steps.size(); ++i) {
      report(run, static_cast<double>(i) / static_cast<double>(steps.size()));
      if (steps[i].before.front().front().stitch < 0) {
        clear_room(steps[i]);
        knit_waste_before(program_, profile_, steps[i].before_hooks, room_of(steps[i]));
      }
      move_loops(steps[i]);
      for (int s = steps[i].first_stitch; s <= steps[i].last_stitch; ++s)
        make_stitch(steps[i], s);
      age_anchors(steps[i]);
      if (end == schedule_.ends.end() || end->step != static_cast<int>(i)) continue;
      clear_room(steps[i]);
      knit_waste_after(program_, profile_, end->hooks, room_of(steps[i]));
      ++end;
    }
    report(run, 1.0);
    return program_.finish();
  }

 private:
  struct Anchors {
    int yarn = 0, tube = 0;
    int steps = 0;  // of the tube since
    std::vector<Needle> needles;
  };

  static PlaceRange room_of(const ScheduleStep& step) {
    return {step.lowest_place, step.highest_place};
  }

  void move_loops(const ScheduleStep& step) {
    const TransferPlan plan = plan_moves(step);
    // Anchors lie on parked needles, which transfers need.
    if (!plan.transfers.empty()) drop_anchors([](const Anchors&) { return true; });
    for (const Transfer& transfer : plan.transfers)
      program_.transfer(half_gauge_needle(transfer.from), half_gauge_needle(transfer.to));
  }

  TransferPlan plan_moves(const ScheduleStep& step) {
    try {
      return plan_step_transfers(step, transfer_direction(trace_, step), profile_, planner_);
    } catch (const NotKnittable&) {
      refuse_transfers(trace_, step);  // the planner knows loops by number, a modeler by node
    }
  }

  void make_stitch(const ScheduleStep& step, int s) {
    const Stitch& stitch = trace_.stitches[s];
    const Hook& hook = step.stitch_hooks[s - step.first_stitch];
    const Source source{Source::Kind::stitch, s};
    const Side side = travel(hook.bed, stitch.direction);
    const YarnUse& yarn = yarns_[stitch.yarn];
    if (s == yarn.first_stitch) {
      clear_room(step);
      anchors_.push_back(
          {stitch.yarn, step.tube, 0,
           bring_in(program_, profile_, yarn.carrier, hook, side, room_of(step))});
    }
    if (stitch.kind == StitchKind::tuck) {
      program_.tuck(side, needle_of(hook), yarn.carrier, source);
    } else {
      program_.knit(side, needle_of(hook), yarn.carrier, source);
    }
    if (stitch.kind == StitchKind::increase) {
      // Against the course, so that the loop is twisted and leaves no hole. Round the end of
      // the tube that is the other side of the other bed.
      const Hook& second = step.second_loop_hooks[s - step.first_stitch];
      program_.tuck(reverse(travel(second.bed, stitch.direction)), needle_of(second),
                    yarn.carrier, source);
    }
    if (s != yarn.last_stitch) return;
    drop_anchors([&](const Anchors& anchors) { return anchors.yarn == stitch.yarn; });
    take_out(program_, profile_, yarn.carrier);
  }

  // Anchors of a neighbour may lie in the places between two tubes.
  void clear_room(const ScheduleStep& step) {
    drop_anchors([&](const Anchors& anchors) {
      return std::any_of(anchors.needles.begin(), anchors.needles.end(), [&](const Needle& n) {
        return n.index >= 2 * step.lowest_place && n.index <= 2 * step.highest_place + 1;
      });
    });
  }

  void age_anchors(const ScheduleStep& step) {
    if (step.last_stitch < step.first_stitch) return;
    for (Anchors& anchors : anchors_) anchors.steps += anchors.tube == step.tube ? 1 : 0;
    drop_anchors([](const Anchors& anchors) { return anchors.steps >= kAnchoredSteps; });
  }

  template <class Which>
  void drop_anchors(Which which) {
    for (const Anchors& anchors : anchors_)
      if (which(anchors))
        for (const Needle& needle : anchors.needles) program_.drop(needle);
    anchors_.erase(std::remove_if(anchors_.begin(), anchors_.end(), which), anchors_.end());
  }

  const StitchTrace& trace_;
  const Schedule& schedule_;
  const MachineProfile& profile_;
  std::vector<YarnUse> yarns_;
  ProgramBuilder program_;
  TransferPlanner planner_;
  std::vector<Anchors> anchors_;  // that lie on the beds
};

}  // namespace

Program emit_program(const StitchTrace& trace, const Schedule& schedule,
                     const MachineProfile& profile, RunContext* run) {
  return Emitter(trace, schedule, profile).run(run);
}

}  // namespace meshknit
