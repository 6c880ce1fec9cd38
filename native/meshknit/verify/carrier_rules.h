#pragma once

#include <string>
#include <vector>

#include "meshknit/machine/machine_profile.h"
#include "meshknit/machine/program.h"
#include "meshknit/verify/fabric.h"
#include "meshknit/verify/problem_log.h"

namespace meshknit {

/// The rules of carriers and of the inserting hook (primer, sections 2.4 and 3). Any number of
/// carriers may be in at once; each coming in opens a yarn of the fabric.
///
/// The hook parks just right of the first stitch made with the yarn that it holds. Until it
/// lets go, nothing may be worked right of that stitch.
class CarrierRules {
 public:
  CarrierRules(const MachineProfile& profile, Fabric& fabric, ProblemLog& log)
      : profile_(profile), fabric_(fabric), log_(log) {}

  void bring_in(const Instruction& i);  ///< in, inhook
  void take_out(const Instruction& i);  ///< out, outhook
  void release(const Instruction& i);   ///< releasehook
  void pass_by(const Instruction& i);   ///< miss
  void before_transfer(int line);       ///< xfer, split

  /// A loop is about to be made at `position` (quarter needles, with racking). The yarn it is
  /// made of; one is opened if the carrier was never brought in, so that the check can go on.
  /// Requires: at least one carrier.
  int use(const Instruction& i, int position);

  /// What must be put away at the end of the file.
  void finish();

 private:
  enum class State { out, pending, active };
  struct Carrier {
    std::string name;
    State state = State::out;
    std::vector<std::string> came_with;  // the set of its in or inhook
    bool stitched = false;
    int yarn = -1;
  };

  Carrier& carrier(const std::string& name);
  int open_yarn(Carrier& c, int line);
  bool hook_holds(const std::string& name) const;
  void check_first_stitch(Carrier& c, const Instruction& i, int position);

  const MachineProfile& profile_;
  Fabric& fabric_;
  ProblemLog& log_;
  std::vector<Carrier> carriers_;
  std::vector<std::string> hooked_;  // empty: the hook is free
  int hook_line_ = 0;
  bool hook_parked_ = false;
  int hook_position_ = 0;  // of the first stitch
};

}  // namespace meshknit
