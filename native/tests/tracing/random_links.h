#pragma once

#include <cstdint>
#include <vector>

#include "meshknit/tracing/tube_events.h"

namespace meshknit {

/// Tubes that start, part, meet and end at random, no more than `most` of them. Two tubes that hang
/// at the same time may meet wherever they are, so many cannot hang side by side.
std::vector<TubeLinks> random_links(std::uint64_t seed, int most);

/// Whether the tubes can hang side by side: every order of events is tried, with nothing left out.
bool hang_in_some_order(const std::vector<TubeLinks>& tubes);

}  // namespace meshknit
