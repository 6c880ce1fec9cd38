#include "meshknit/machine/machine_profile.h"

#include "meshknit/core/error.h"

namespace meshknit {
namespace {

MachineProfile shima_swg091n2() {
  MachineProfile p;
  p.name = "shima_swg091n2";
  p.machine_header = "SWG091N2";
  p.gauge = 15;
  p.needles = 540;  // 91 cm at 15 needles an inch
  p.carriers = {"1", "2", "3", "4", "5", "6", "7", "8", "9", "10"};
  // The frontmost carrier takes the waste, so that every yarn of the object can follow behind
  // it without the two changing places.
  p.waste_carrier = "1";
  p.yarn_carrier = "2";
  p.has_inserting_hook = true;
  p.has_sliders = true;
  p.first_stitch_leftward = true;  // carriers come from the right
  p.max_racking = 4;               // the machine does 8; yarn lasts longer at 4
  p.quarter_pitch = 0.25;
  p.max_stack = 3;
  // At half gauge two logical places are 2 needles on one bed and up to 5 across the beds.
  p.max_stretch = 5;
  p.max_float = 7;
  p.waste_rounds = 10;
  p.seconds_per_turn = 0.6;
  p.needles_per_second = 30.0;
  return p;
}

}  // namespace

MachineProfile machine_profile(const std::string& name) {
  if (name == "shima_swg091n2") return shima_swg091n2();
  std::string known;
  for (const std::string& other : machine_profile_names()) {
    known += (known.empty() ? "" : ", ") + other;
  }
  throw InvalidInput("there is no machine profile \"" + name + "\"; known are: " + known);
}

std::vector<std::string> machine_profile_names() { return {"shima_swg091n2"}; }

}  // namespace meshknit
