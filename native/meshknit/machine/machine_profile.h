#pragma once

#include <string>
#include <vector>

namespace meshknit {

/// A machine's limits, as data. Lengths are in real needles, times in seconds.
struct MachineProfile {
  std::string name;
  std::string machine_header;         ///< value of the ";;Machine:" header, empty for none
  int gauge = 15;                     ///< needles an inch
  int needles = 540;                  ///< a bed; numbered from 1
  std::vector<std::string> carriers;  ///< front to back
  std::string waste_carrier;
  std::string yarn_carrier;  ///< first carrier for the object's yarns
  bool has_inserting_hook = true;
  bool has_sliders = true;
  bool first_stitch_leftward =
      true;                     ///< direction of a carrier's first stitch after it came in
  int max_racking = 4;          ///< largest |racking| that programs use
  double quarter_pitch = 0.25;  ///< the only fraction of a racking that exists
  int max_stack = 3;      ///< loops on one needle; one more is refused, this many warned of
  int max_stretch = 5;    ///< needles between yarn neighbours while both are held
  int max_float = 7;      ///< needles between a new loop and the one before on its carrier
  int waste_rounds = 10;  ///< plain rounds of waste before and after the object
  double seconds_per_turn = 0.6;     ///< carriage reversal, a pass
  double needles_per_second = 30.0;  ///< carriage travel
};

/// A built-in profile: "shima_swg091n2". Throws InvalidInput for an unknown name.
MachineProfile machine_profile(const std::string& name);

/// Names of the built-in profiles.
std::vector<std::string> machine_profile_names();

}  // namespace meshknit
