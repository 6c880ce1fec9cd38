#pragma once

#include <optional>
#include <vector>

#include "meshknit/machine/machine_profile.h"
#include "meshknit/schedule/bed_layout.h"
#include "meshknit/schedule/bed_order.h"
#include "meshknit/schedule/connections.h"
#include "meshknit/schedule/tube_steps.h"

namespace meshknit {

/// Places that stay free between tubes that hang side by side, but where they part or meet.
constexpr int kFreeBetween = 1;

/// No limit, for places.
constexpr PlaceRange kAnywhere{-100000, 100000};

/// The half-gauge places that layouts may use: all of a bed's but a few at each end, which
/// transfers and yarn ends need.
PlaceRange usable_places(const MachineProfile& profile);

/// The layouts of a tube: steps between two of them keep the layout that they find.
struct TubeLayouts {
  std::vector<BedLayout> layouts;
  std::vector<SlotMap> maps;   ///< [i] leads from layout i to i + 1
  std::vector<int> from_step;  ///< [i] the step that goes from layout i to i + 1, ascending
};

/// A step, or a move of a whole tube between steps, on its needles.
struct PlacedStep {
  int tube = 0;
  int step = -1;  ///< of the tube; -1: the tube is only moved
  BedLayout before, after;
  PlaceRange room;        ///< from one neighbour to the other: what transfers may use
  int bridge_beside = 1;  ///< longest_bridge of the tubes beside it
};

struct PlacedTubes {
  std::vector<PlacedStep> steps;
  bool optimal =
      true;  ///< no layout had to move further than its best, nor a tube out of the way
};

/// Gives every layout its place, step by step. A tube moves by the offset of least movement that
/// its neighbours leave; of equally good ones, towards the tube that it will meet, else so that it
/// stays in its middle. Neighbours are only moved where a tube grows into them. Where tubes part,
/// the one that is worked first moves away by kFreeBetween; where they meet, the smaller one comes
/// to the other. The whole is centred on the bed.
/// Requires: tubes held together fit into usable_places(profile) side by side.
/// Ensures: so they do in the result.
PlacedTubes place_tubes(const SteppedTubes& tubes, const std::vector<Connection>& connections,
                        const BedOrder& order, const std::vector<TubeLayouts>& layouts,
                        const MachineProfile& profile);

}  // namespace meshknit
