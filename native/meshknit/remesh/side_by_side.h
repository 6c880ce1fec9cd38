#pragma once

#include <vector>

#include "meshknit/knit_graph/ring_parts.h"

namespace meshknit {

/// The parts of a ring by nearness, which is never quite clean: stretches that weigh less than
/// `least` first count as the heavier of their neighbours, the lightest of all before others. Then as
/// ring_parts; empty unless all `parts` have a stretch. `part` and `weight` follow the ring.
std::vector<PartStretch> side_by_side(const std::vector<int>& part,
                                      const std::vector<double>& weight, int parts,
                                      double least);

/// Moves the ends of stretches so that the two of each middle part are equally long, that the parts
/// hang as aligned_ends has it, each with `fewest` elements or more, and that the sum of
/// cost[part][element] is least (paper, appendix A, splits). No end moves further than `reach`.
/// Empty if that cannot be.
std::vector<PartStretch> balance(const std::vector<PartStretch>& given,
                                 const std::vector<std::vector<double>>& cost, int fewest,
                                 int reach);

}  // namespace meshknit
