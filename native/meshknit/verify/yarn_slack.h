#pragma once

#include <vector>

#include "meshknit/machine/machine_profile.h"
#include "meshknit/verify/fabric.h"
#include "meshknit/verify/problem_log.h"

namespace meshknit {

/// Watches the length of yarn between neighbouring loops (primer, section 7, step 6). A pair
/// that is held may never be further apart, in needles at the racking in force, than the
/// profile's max_stretch or its distance when it was made; a new loop may be at most max_float
/// from the loop before it.
///
/// Work is done only for pairs that something happened to: those of loops that moved, and on a
/// new racking those that bridge the beds.
class YarnSlack {
 public:
  YarnSlack(Fabric& fabric, const MachineProfile& profile, ProblemLog& log)
      : fabric_(fabric), profile_(profile), log_(log) {}

  /// The newest loop, hanging on its needle.
  void made(int loop, int racking);
  /// A loop that hangs on another needle now.
  void moved(int loop, int racking, int line);
  /// A loop that is no longer held.
  void let_go(int loop);
  void racked(int racking, int line);

 private:
  // A pair is named by its second loop.
  bool held(int pair) const;
  void check(int pair, int racking, int line);
  void watch_bridge(int pair);
  void unwatch_bridge(int pair);

  Fabric& fabric_;
  const MachineProfile& profile_;
  ProblemLog& log_;
  std::vector<int> bridges_;    // pairs that are held on opposite beds
  std::vector<int> bridge_at_;  // loop -> place in bridges_, -1 if not there
};

/// Quarter needles between two needles when the back bed is shifted by `racking` quarter
/// needles.
int needle_distance(const Needle& a, const Needle& b, int racking);

}  // namespace meshknit
