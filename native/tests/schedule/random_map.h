#pragma once

#include "graphs.h"
#include "meshknit/schedule/slot_map.h"

namespace meshknit {

/// A random step over this many stacks: about one in five is decreased with the stack before
/// it, as many are followed by a gap. In either direction.
SlotMap random_map(Dice& dice, int stacks);

}  // namespace meshknit
