#pragma once

#include <vector>

#include "meshknit/core/problem.h"
#include "meshknit/machine/needle.h"

namespace meshknit {

/// One loop stack of a tube: where it hangs and where it must go, both on hooks (not parked).
struct TransferLoop {
  Bed from_bed = Bed::front;
  int from = 0;
  Bed to_bed = Bed::front;
  int to = 0;
};

/// Moving the loops of one tube (knitout primer, section 4). Needles are half-gauge places.
/// Requires: `loops` in anticlockwise order round the tube (front left to right, then back
/// right to left, starting anywhere), both for `from` and for `to`; no two loops share a
/// `from`; loops that share a `to` are neighbours (a decrease). Loops with a common target must
/// arrive in the order of `loops`: the first lies below. Order goes round the tube, so where
/// such a group runs over the end of the list, the loops at the end of the list lie below those
/// at its start.
struct TransferProblem {
  std::vector<TransferLoop> loops;
  std::vector<int>
      slack;  ///< needles (real) allowed between loop i and the next one round the tube
  int max_racking = 4;          ///< real needles
  int lowest = 0, highest = 0;  ///< half-gauge places that may be used, both beds, inclusive
};

/// The usual slack of every pair: 2 max(1, distance before, distance after) + 1 real needles,
/// where distances are those of half-gauge places at racking 0 (same bed |i-j|; across the beds
/// |i-j|).
std::vector<int> usual_slack(const std::vector<TransferLoop>& loops);

/// One transfer between half-gauge places of opposite beds. Its racking is
/// racking_between(half_gauge_needle(from), half_gauge_needle(to)).
struct Transfer {
  Place from, to;
};

/// The racking (real needles) at which a transfer happens.
inline int racking_of(const Transfer& transfer) {
  return racking_between(half_gauge_needle(transfer.from), half_gauge_needle(transfer.to));
}

struct TransferPlan {
  std::vector<Transfer> transfers;  ///< in order
};

/// Passes of a plan: runs of transfers with the same racking and the same direction (front to
/// back or back to front).
int count_passes(const TransferPlan& plan);

}  // namespace meshknit
