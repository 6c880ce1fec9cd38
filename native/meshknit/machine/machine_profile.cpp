#include "meshknit/machine/machine_profile.h"

#include <algorithm>

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
  p.settings = {{"x-stitch-number", 1, 120},
                {"x-speed-number", 0, 15},
                {"x-sub-roller-number", 0, 31},
                {"x-presser-mode"},
                {"stitch"}};
  return p;
}

MachineProfile kniterate() {
  MachineProfile p;
  p.name = "kniterate";
  p.machine_header = "Kniterate";
  p.gauge = 7;
  p.needles = 252;
  p.carriers = {"1", "2", "3", "4", "5", "6"};
  // As its owners load it.
  p.draw_carrier = "1";
  p.yarn_carrier = "2";
  p.waste_carrier = "6";
  p.has_inserting_hook = false;
  p.has_sliders = false;
  p.first_stitch_leftward = false;  // carriers park on the left
  p.max_racking = 4;
  p.liked_racking = 2;
  p.quarter_pitch = 0.5;
  p.waste_rounds = 10;
  // Nothing holds the fabric before it reaches the rollers, after some 70 courses.
  p.take_down_rounds = 70;
  p.take_down_width = 20;
  p.tucks_beside_knits = false;
  p.transfers_in_halves = true;
  p.takes_kcode = true;
  p.seconds_per_turn = 1.0;
  p.needles_per_second = 80.0;
  p.settings = {{"x-stitch-number", 0, 15},
                {"x-xfer-stitch-number", 0, 15},
                {"x-speed-number", 0, 600},
                {"x-roller-advance", 0, 1000},
                {"x-add-roller-advance", -1000, 1000},
                {"x-carrier-spacing", 0, 10},
                {"x-carrier-stopping-distance", 0, 10},
                {"x-xfer-style"},
                {"x-end-pass"},
                {"stitch"}};
  p.first_settings = {"x-stitch-number 5", "x-xfer-stitch-number 3", "x-speed-number 300",
                      "x-roller-advance 300"};
  return p;
}

}  // namespace

MachineProfile machine_profile(const std::string& name) {
  if (name == "shima_swg091n2") return shima_swg091n2();
  if (name == "kniterate") return kniterate();
  std::string known;
  for (const std::string& other : machine_profile_names()) {
    known += (known.empty() ? "" : ", ") + other;
  }
  throw InvalidInput("there is no machine profile \"" + name + "\"; known are: " + known);
}

std::vector<std::string> machine_profile_names() { return {"shima_swg091n2", "kniterate"}; }

std::vector<std::string> carriers_for_yarn(const MachineProfile& profile) {
  std::vector<std::string> carriers = profile.carriers;
  const auto first = std::find(carriers.begin(), carriers.end(), profile.yarn_carrier);
  std::rotate(carriers.begin(), first, carriers.end());
  carriers.erase(std::remove_if(carriers.begin(), carriers.end(),
                                [&](const std::string& carrier) {
                                  return carrier == profile.waste_carrier ||
                                         carrier == profile.draw_carrier;
                                }),
                 carriers.end());
  return carriers;
}

}  // namespace meshknit
