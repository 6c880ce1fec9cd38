#include "meshknit/schedule/tube_layouts.h"

#include <algorithm>

namespace meshknit {
namespace {

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
      shaping_(tubes.tubes.size()) {
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

FoundLayouts LayoutChoices::search(int tube, int left_below, int left_above,
                                   RunContext* run) const {
  LayoutLimits limits;
  limits.beside_others = tubes_.tubes.size() > 1;
  if (below_[tube] >= 0) limits.first = layout_at(connections_[below_[tube]], left_below, tube);
  if (above_[tube] >= 0) limits.last = layout_at(connections_[above_[tube]], left_above, tube);
  const int slots = static_cast<int>(tubes_.tubes[tube].steps.front().before.size());
  return search_layouts(slots, shaping_[tube].maps, limits, run);
}

std::vector<TubeCosts> LayoutChoices::costs(RunContext* run) const {
  std::vector<TubeCosts> costs(tubes_.tubes.size(), TubeCosts{});
  if (connections_.empty()) return costs;
  for (int t = 0; t < static_cast<int>(costs.size()); ++t)
    for (const int below : {0, 1})
      for (const int above : {0, 1}) {
        // A free end is the same either way.
        if ((below == 1 && below_[t] < 0) || (above == 1 && above_[t] < 0)) {
          costs[t][below][above] =
              costs[t][below_[t] < 0 ? 0 : below][above_[t] < 0 ? 0 : above];
          continue;
        }
        const FoundLayouts found = search(t, below, above, run);
        costs[t][below][above] = {found.rolls, found.moves.beyond, found.moves.shift,
                                  found.moves.travel};
      }
  return costs;
}

std::vector<TubeLayouts> LayoutChoices::layouts(const BedOrder& order, RunContext* run) const {
  const auto left = [&](int connection) {
    return connection < 0 ? 0 : order.left_part[connection];
  };
  std::vector<TubeLayouts> layouts = shaping_;
  for (int t = 0; t < static_cast<int>(layouts.size()); ++t)
    layouts[t].layouts = search(t, left(below_[t]), left(above_[t]), run).layouts;
  return layouts;
}

}  // namespace meshknit
