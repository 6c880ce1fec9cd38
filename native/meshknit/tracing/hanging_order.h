#pragma once

#include <vector>

#include "meshknit/tracing/tube_events.h"

namespace meshknit {

/// An order of events in which tubes hang side by side without crossing.
struct HangingOrder {
  enum class Verdict { found, none, unknown } verdict = Verdict::unknown;
  std::vector<TubeEvent> events;  ///< if found
};

/// Any order of events in which no tubes cross: an upward planar drawing of the Reeb graph (paper,
/// section 2.2). Pieces that are not joined to each other follow one after another. Whatever sets
/// places free or keeps all orders open is done at once: tubes that can end do, those that hang side
/// by side and meet do, also with tubes that have yet to start, and tubes part. What is left to choose
/// is which way round tubes part, and where and when others start. `unknown` if there are too many
/// ways to try; never for a dozen tubes.
HangingOrder find_hanging_order(const std::vector<TubeLinks>& tubes);

/// True if the tubes can hang side by side without crossing in some order of events, or if there are
/// too many to try.
bool can_hang(const std::vector<TubeLinks>& tubes);

}  // namespace meshknit
