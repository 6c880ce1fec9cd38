#include "meshknit/schedule/tube_layouts.h"

#include <algorithm>
#include <array>
#include <limits>

namespace meshknit {
namespace {

// Rolls more than needed at which it hardly matters what else a tube's layouts cost, and about what
// each of them does.
constexpr long kFarTurned = 12;
constexpr long kPassesPerRoll = 3;

// The layout that a connection gives to a tube.
BedLayout layout_at(const Connection& connection, int left, int tube) {
  const ConnectionLayout layout = connection_layout(connection, left);
  if (connection.whole == tube) return layout.whole;
  const auto part = std::find(connection.parts.begin(), connection.parts.end(), tube);
  return layout.parts[part - connection.parts.begin()];
}

}  // namespace

LayoutChoices::LayoutChoices(const SteppedTubes& tubes,
                             const std::vector<Connection>& connections)
    : tubes_(tubes),
      connections_(connections),
      below_(tubes.tubes.size(), -1),
      above_(tubes.tubes.size(), -1),
      shaping_(tubes.tubes.size()),
      found_(tubes.tubes.size()) {
  for (int c = 0; c < static_cast<int>(connections.size()); ++c) {
    const Connection& connection = connections[c];
    (connection.split ? above_ : below_)[connection.whole] = c;
    for (const int part : connection.parts) (connection.split ? below_ : above_)[part] = c;
  }
  for (size_t t = 0; t < tubes.tubes.size(); ++t) {
    const std::vector<TubeStep>& steps = tubes.tubes[t].steps;
    const auto move_in = [&](size_t step) {
      shaping_[t].maps.push_back(steps[step].map);
      shaping_[t].from_step.push_back(static_cast<int>(step));
    };
    for (size_t step = 0; step < steps.size(); ++step)
      if (!steps[step].map.is_identity()) move_in(step);
    if (shaping_[t].maps.empty() && below_[t] >= 0 && above_[t] >= 0) move_in(steps.size() - 1);
  }
}

LayoutLimits LayoutChoices::limits(int tube, int left_below, int left_above) const {
  LayoutLimits limits;
  if (below_[tube] >= 0) limits.first = layout_at(connections_[below_[tube]], left_below, tube);
  if (above_[tube] >= 0) limits.last = layout_at(connections_[above_[tube]], left_above, tube);
  return limits;
}

int LayoutChoices::first_slots(int tube) const {
  return static_cast<int>(tubes_.tubes[tube].steps.front().before.size());
}

const FoundLayouts& LayoutChoices::found(int tube, int left_below, int left_above,
                                         RunContext* run) {
  std::optional<FoundLayouts>& known = found_[tube][left_below][left_above];
  if (!known)
    known = search_layouts(first_slots(tube), shaping_[tube].maps,
                           limits(tube, left_below, left_above), run);
  return *known;
}

TubeCosts LayoutChoices::costs_of(int tube, RunContext* run) {
  const std::vector<SlotMap>& maps = shaping_[tube].maps;
  const int slots = first_slots(tube);
  // A free end is the same either way.
  const int ways_below = below_[tube] < 0 ? 1 : 2, ways_above = above_[tube] < 0 ? 1 : 2;
  std::array<std::array<long, 2>, 2> rolls{};
  long fewest = std::numeric_limits<long>::max(), least = fewest;
  const auto for_each_way = [&](auto visit) {
    for (int below = 0; below < ways_below; ++below)
      for (int above = 0; above < ways_above; ++above) visit(below, above);
  };
  for_each_way([&](int below, int above) {
    rolls[below][above] = fewest_rolls(slots, maps, limits(tube, below, above), run);
    fewest = std::min(fewest, rolls[below][above]);
  });
  TubeCosts costs{};
  for_each_way([&](int below, int above) {
    if (rolls[below][above] > fewest + kFarTurned) return;
    const MoveCost& cost = found(tube, below, above, run).cost;
    costs[below][above] = {cost.passes, cost.shift, cost.travel};
    least = std::min(least, cost.passes);
  });
  for_each_way([&](int below, int above) {
    const long more = rolls[below][above] - fewest;
    if (more > kFarTurned) costs[below][above] = {least + kPassesPerRoll * more, 0, 0};
  });
  for (const int below : {0, 1})
    for (const int above : {0, 1})
      costs[below][above] =
          costs[std::min(below, ways_below - 1)][std::min(above, ways_above - 1)];
  return costs;
}

std::vector<TubeCosts> LayoutChoices::costs(RunContext* run) {
  std::vector<TubeCosts> costs(tubes_.tubes.size(), TubeCosts{});
  if (connections_.empty()) return costs;
  for (int t = 0; t < static_cast<int>(costs.size()); ++t) costs[t] = costs_of(t, run);
  return costs;
}

std::vector<TubeLayouts> LayoutChoices::layouts(const BedOrder& order, bool narrow,
                                                RunContext* run) {
  const auto left = [&](int connection) {
    return connection < 0 ? 0 : order.left_part[connection];
  };
  std::vector<TubeLayouts> layouts = shaping_;
  for (int t = 0; t < static_cast<int>(layouts.size()); ++t) {
    const int below = left(below_[t]), above = left(above_[t]);
    if (!narrow) {
      layouts[t].layouts = found(t, below, above, run).layouts;
      continue;
    }
    LayoutLimits own = limits(t, below, above);
    own.narrow = true;
    layouts[t].layouts = search_layouts(first_slots(t), shaping_[t].maps, own, run).layouts;
  }
  return layouts;
}

}  // namespace meshknit
