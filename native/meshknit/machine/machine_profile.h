#pragma once

#include <string>
#include <vector>

namespace meshknit {

/// An extension operation of knitout that a machine knows: "name value", the value a whole number
/// in a range or a hexadecimal digit, or a word if the range is empty.
struct MachineSetting {
  std::string name;
  int lowest = 0, highest = -1;
};

/// A machine's limits, as data. Lengths are in real needles, times in seconds.
struct MachineProfile {
  std::string name;
  std::string machine_header;         ///< value of the ";;Machine:" header, empty for none
  int gauge = 15;                     ///< needles an inch
  int needles = 540;                  ///< a bed; numbered from 1
  std::vector<std::string> carriers;  ///< front to back
  std::string waste_carrier;
  std::string draw_carrier;  ///< of the thread between waste and object, empty for none
  std::string yarn_carrier;  ///< first carrier for the object's yarns
  bool has_inserting_hook = true;
  bool has_sliders = true;
  bool first_stitch_leftward =
      true;                     ///< direction of a carrier's first stitch after it came in
  int max_racking = 4;          ///< largest |racking| that programs use
  int liked_racking = 4;        ///< larger ones strain the yarn: only where nothing else helps
  double quarter_pitch = 0.25;  ///< the only fraction of a racking that exists
  int max_stack = 3;         ///< loops on one needle; one more is refused, this many warned of
  int max_stretch = 5;       ///< needles between yarn neighbours while both are held
  int max_float = 7;         ///< needles between a new loop and the one before on its carrier
  int waste_rounds = 10;     ///< plain rounds of waste before and after the object
  int take_down_rounds = 0;  ///< that it takes before, if more, till fabric reaches the rollers
  int take_down_width = 0;   ///< needles that fabric must span for the rollers to hold it
  bool tucks_beside_knits = true;        ///< one bed can do both in one pass
  bool transfers_in_halves = false;      ///< every second loop in one pass, the rest in another
  bool takes_kcode = false;              ///< the machine reads .kc files (knitout/kcode.h)
  double seconds_per_turn = 0.6;         ///< carriage reversal, a pass
  double needles_per_second = 30.0;      ///< carriage travel
  std::vector<MachineSetting> settings;  ///< extensions that the machine knows
  std::vector<std::string> first_settings;  ///< those that programs begin with, as written
};

/// A built-in profile: "shima_swg091n2", "kniterate". Throws InvalidInput for an unknown name.
MachineProfile machine_profile(const std::string& name);

/// Names of the built-in profiles.
std::vector<std::string> machine_profile_names();

/// The carriers that are free for yarns of the object, in the order in which they are taken: from
/// yarn_carrier on, without those of waste and draw thread.
std::vector<std::string> carriers_for_yarn(const MachineProfile& profile);

}  // namespace meshknit
