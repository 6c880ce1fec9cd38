// A .kc file that differs from its knitout file does not leave.

#include "meshknit/verify/kcode_check.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <functional>
#include <string>
#include <vector>

#include "branching_graphs.h"
#include "meshknit/emit/emit_program.h"
#include "meshknit/knitout/kcode_plan.h"
#include "meshknit/knitout/knitout_writer.h"
#include "meshknit/schedule/schedule.h"
#include "meshknit/tracing/trace.h"

namespace meshknit {
namespace {

const MachineProfile& kniterate() {
  static const MachineProfile profile = machine_profile("kniterate");
  return profile;
}

// A trunk that parts into three legs, side by side with a carrier each.
struct Files {
  std::vector<KcodePass> sweeps;
  std::string knitout;

  Files() {
    const StitchTrace trace = trace_knit_graph(three_legs(6, 7, 8, 5, 1), 4);
    const Program program =
        emit_program(trace, schedule_stitches(trace, kniterate()), kniterate());
    sweeps = plan_kcode(program, kniterate());
    knitout = write_knitout(program);
  }
  Problems check() const {
    return check_kcode(write_kcode(sweeps, kniterate().needles), knitout, kniterate());
  }
  // The n-th sweep that makes loops with the object's yarn.
  KcodePass& knitting(int n) {
    return *std::find_if(sweeps.begin(), sweeps.end(), [&](const KcodePass& sweep) {
      return sweep.carrier >= 2 && sweep.carrier <= 5 && sweep.front.size() >= 2 && n-- == 0;
    });
  }
  KcodePass& handing_over() {
    return *std::find_if(sweeps.begin(), sweeps.end(), [](const KcodePass& sweep) {
      return sweep.kind != KcodePass::Kind::yarn;
    });
  }
};

TEST(KcodeCheck, WhatWasPlannedMakesTheSameLoops) {
  const Files files;
  for (const Problem& p : files.check()) ADD_FAILURE() << p.code << ": " << p.message;
}

TEST(KcodeCheck, EveryDifferenceIsNoticed) {
  struct Damage {
    const char* what;
    const char* code;
    std::function<void(Files&)> damage;
  };
  const std::vector<Damage> damages = {
      {"a forgotten needle", "kcode-differs",
       [](Files& f) { f.knitting(3).front.erase(f.knitting(3).front.begin()); }},
      {"a needle too many", "kcode-differs",
       [](Files& f) {
         std::vector<int>& front = f.knitting(3).front;
         front.insert(front.begin() + 1, front[0] + 1);
       }},
      {"tucked, not knit", "kcode-differs", [](Files& f) { f.knitting(3).front_tucks = true; }},
      {"knit in another stitch's place", "kcode-differs",
       [](Files& f) { std::swap(f.knitting(3).front, f.knitting(3).rear); }},
      {"a forgotten transfer", "kcode-differs",
       [](Files& f) {
         f.handing_over().front.pop_back();
         f.handing_over().rear.pop_back();
       }},
      {"a transfer the other way", "kcode-differs",
       [](Files& f) {
         KcodePass::Kind& kind = f.handing_over().kind;
         kind = kind == KcodePass::Kind::front_to_back ? KcodePass::Kind::back_to_front
                                                       : KcodePass::Kind::front_to_back;
       }},
      {"a transfer at another racking", "bad-kcode",
       [](Files& f) { f.handing_over().racking += 1; }},
      {"another carrier", "carrier-elsewhere", [](Files& f) { f.knitting(3).carrier = 5; }},
      {"a carrier from elsewhere", "carrier-elsewhere",
       [](Files& f) {
         KcodePass& sweep = f.knitting(3);
         if (sweep.direction == Side::right)
           ++sweep.carrier_left;
         else
           --sweep.carrier_right;
       }},
      {"a carrier left where needles work", "carrier-in-the-way",
       [](Files& f) {
         const auto moved = std::find_if(
             f.sweeps.begin(), f.sweeps.end(),
             [](const KcodePass& s) { return s.comment == "carrier out of the way"; });
         moved->carrier = moved->carrier_left = moved->carrier_right = 0;
       }},
      {"the carriage twice the same way", "bad-kcode",
       [](Files& f) { f.sweeps.erase(f.sweeps.begin() + 20); }},
      {"the carriage turns elsewhere", "bad-kcode",
       [](Files& f) {
         f.sweeps[20].carriage_right += 1;
         f.sweeps[20].carriage_left -= 1;
       }},
      {"the last drops missing", "kcode-differs", [](Files& f) { f.sweeps.pop_back(); }},
  };
  for (const Damage& damage : damages) {
    Files files;
    damage.damage(files);
    EXPECT_NE(find_problem(files.check(), damage.code), nullptr) << damage.what;
  }
}

}  // namespace
}  // namespace meshknit
