#pragma once

#include <array>
#include <vector>

#include "meshknit/schedule/connections.h"
#include "meshknit/schedule/tube_steps.h"

namespace meshknit {

/// What a tube's layouts cost, compared lexicographically: passes, shifts, travel (layout_cost.h).
using TubeCost = std::array<long, 3>;

/// [which outer part is left at the connection below: 0 the first, 1 the last][the same above]. A tube without a
/// connection on one side has the same cost twice.
using TubeCosts = std::array<std::array<TubeCost, 2>, 2>;

/// How the tubes hang side by side: an upward planar drawing of the Reeb graph whose order of
/// events is given (paper, sections 2.2 and 3.4).
struct BedOrder {
  std::vector<int> left_part;  ///< [connection] 0: parts from left to right, 1: the other way
  /// The tubes held during each turn, left to right. A split's parts all hang there from the first
  /// step of any on.
  std::vector<std::vector<int>> held;
  bool optimal = true;  ///< no order costs less
};

/// The order with the least cost over all tubes; equally good ones by how many tubes must make room
/// where one starts between others. Searched event by event over all orders that differ in what
/// can follow, so exact while they are not too many (always for up to 12 tubes); otherwise the
/// cheapest are followed.
/// Throws: NotKnittable "tubes-cross" if tubes that must meet always have another between them, or hang
/// in another order;
/// names the tubes' stitches and nodes.
BedOrder choose_order(const StitchTrace& trace, const SteppedTubes& tubes,
                      const std::vector<Connection>& connections,
                      const std::vector<TubeCosts>& costs);

}  // namespace meshknit
