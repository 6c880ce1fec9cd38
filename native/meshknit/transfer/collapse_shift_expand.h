#pragma once

#include "meshknit/transfer/tube.h"

namespace meshknit {

/// One iteration of collapse-shift-expand (McCann et al. 2016; knitout primer, section 4.1), which
/// takes the whole tube along:
///  1. collapse: the loops of one bed go over to the other, from its two ends inwards, each to
///     the parking needle (or, round an end, the hook) that leaves it the least way to its goal;
///  2. shift: all of them come over at the one racking that leaves the least way in all;
///  3. expand: the loops of the other bed go back, from the middle outwards, each by its own
///     offset; loops at the ends may go round them.
/// Of the orders in which loops can go, one with the least way that is left, then with the fewest
/// passes; either bed may be collapsed, whichever is better in the same sense. Parking needles
/// stand for the primer's sliders, and loops of a decrease arrive in the order that
/// TransferProblem asks for.
///
/// Brings the tube nearer to its goal and appends to the plan; false, and nothing changed, if it
/// cannot (a decrease may ask for an order that this way of moving does not give).
/// Requires: not tube.arrived(); all stacks on hooks, no two on one.
bool collapse_shift_expand(Tube& tube, TransferPlan& plan);

}  // namespace meshknit
