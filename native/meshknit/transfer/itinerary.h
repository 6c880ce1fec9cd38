#pragma once

#include <array>
#include <vector>

#include "meshknit/transfer/pass.h"
#include "meshknit/transfer/stop.h"
#include "meshknit/transfer/tube.h"

namespace meshknit {

constexpr int most_passes = 16;

/// What one stack does in a sequence of passes: stops[k] before pass k, stops[passes] at the
/// end.
struct Itinerary {
  std::array<Stop, most_passes + 1> stops;
  int transfers = 0;
};

/// What a stack may end with.
enum class Ending {
  goal,     ///< on its goal hook
  any_hook  ///< on a hook of any place
};

/// All ways of a block's first stack through the passes; the others of the block do the same,
/// beside it. Stacks go round ends only towards their goal side. The way that waits longest
/// comes first.
/// Requires: at most most_passes passes.
std::vector<Itinerary> itineraries(const Tube& tube, const Block& block, const Passes& passes,
                                   Ending ending);

/// Shifted by whole places: the same way for another stack of the block.
Itinerary beside(const Itinerary& itinerary, int places);

/// True if stack `a` and the one after it may hang so while the beds are racked so: slack
/// and order kept. `turn` is added to the second one's sides (2 for the pair that
/// closes the tube).
bool compatible_at(const Stack& a, const Stop& stop_a, const Stop& stop_b, int turn,
                   int racking);

/// True if they may do this in one pass: slack and order kept, one needle shared only for one
/// goal, with `b` coming down onto `a`, and not left again by one of them alone.
bool compatible_in(const Pass& pass, const Stack& a, const Stop& from_a, const Stop& to_a,
                   const Stack& b, const Stop& from_b, const Stop& to_b, int turn);

/// True if they may take these ways, and hang as they end at racking 0.
bool compatible(const Stack& a, const Itinerary& way_a, const Stack& b, const Itinerary& way_b,
                int turn, const Passes& passes);

}  // namespace meshknit
