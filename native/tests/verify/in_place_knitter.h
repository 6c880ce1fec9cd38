#pragma once

#include <string>
#include <vector>

#include "meshknit/machine/needle.h"
#include "meshknit/tracing/stitch.h"

namespace meshknit {

/// Knits a trace without increases and decreases on the Shima, every column on one needle from
/// beginning to end: no transfers at all. `rounds` gives the needles of each round of starts, in
/// the order of the starts, with a free needle right of every needle. Each round stands on waste of
/// its own, every yarn is anchored beside its first stitch, carriers are used again. Lines of
/// knitout.
std::vector<std::string> knit_in_place(const StitchTrace& trace,
                                       const std::vector<std::vector<Needle>>& rounds);

/// `count` places at half gauge from place `left` on, in anticlockwise order: the front bed's
/// rightward, the back bed's leftward.
std::vector<Needle> front_places(int left, int count);
std::vector<Needle> back_places(int left, int count);

}  // namespace meshknit
