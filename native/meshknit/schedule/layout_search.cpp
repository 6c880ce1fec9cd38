#include "meshknit/schedule/layout_search.h"

#include <algorithm>

#include "meshknit/core/error.h"
#include "meshknit/schedule/layout_cost.h"
#include "meshknit/schedule/roll_search.h"

namespace meshknit {
namespace {

// The layouts of one split that can be best: aligned for N even, flush at the left or at the
// right for N odd.
int flushes(int slots) { return slots % 2 == 0 ? 1 : 2; }

BedLayout flush_layout(const BedSplits& splits, int split, int flush) {
  BedLayout layout = splits.layout(split);
  if (flush == 1) layout.shape.left = 2 * layout.shape.front > layout.slots ? 1 : -1;
  return layout;
}

struct Reached {
  ShiftCost cost;
  int from = -1;  // layout of the cycle before; -1: none
  bool reached = false;
};

class LayoutSearch {
 public:
  LayoutSearch(int slots, const std::vector<SlotMap>& maps, RunContext* run)
      : maps_(maps), run_(run) {
    splits_.reserve(maps.size() + 1);
    splits_.emplace_back(slots);
    for (const SlotMap& map : maps) splits_.emplace_back(map.slots());
  }

  std::vector<BedLayout> run() {
    const RollTable rolls = search_rolls(splits_, maps_, run_);
    from_.assign(splits_.size(), {});
    std::vector<Reached> reached(splits_[0].size() * flushes(splits_[0].slots()));
    for (Reached& layout : reached) layout.reached = true;
    for (size_t i = 0; i < maps_.size(); ++i) {
      report(run_, static_cast<double>(i) / static_cast<double>(maps_.size()));
      reached = advance(i, reached, rolls);
    }
    return walk_back(reached, rolls);
  }

 private:
  std::vector<Reached> advance(size_t i, const std::vector<Reached>& here,
                               const RollTable& rolls) {
    const BedSplits &before = splits_[i], &after = splits_[i + 1];
    const int ways = flushes(before.slots()), next_ways = flushes(after.slots());
    std::vector<Reached> next(after.size() * next_ways);
    const std::vector<int>& to_end = rolls.to_end[i + 1];
    const int least_left = *std::min_element(to_end.begin(), to_end.end());
    for (int split = 0; split < before.size(); ++split) {
      if (!rolls.on_best_way(static_cast<int>(i), split)) continue;
      const int left = rolls.to_end[i][split];
      for_each_split_within(
          maps_[i], before.layout(split), after, left - least_left, [&](int to, int cost) {
            if (cost + to_end[to] != left) return;
            for (int way = 0; way < ways; ++way)
              for (int next_way = 0; next_way < next_ways; ++next_way) {
                const int from = split * ways + way;
                const ShiftCost total =
                    here[from].cost + meter_.measure(maps_[i], flush_layout(before, split, way),
                                                     flush_layout(after, to, next_way));
                Reached& candidate = next[to * next_ways + next_way];
                if (candidate.reached && !(total < candidate.cost)) continue;
                candidate = {total, from, true};
              }
          });
    }
    from_[i + 1].reserve(next.size());
    for (const Reached& layout : next) from_[i + 1].push_back(layout.from);
    return next;
  }

  std::vector<BedLayout> walk_back(const std::vector<Reached>& last,
                                   const RollTable& rolls) const {
    const int end = static_cast<int>(splits_.size()) - 1;
    int best = -1;
    const int ways = flushes(splits_[end].slots());
    for (int layout = 0; layout < static_cast<int>(last.size()); ++layout)
      if (last[layout].reached && rolls.on_best_way(end, layout / ways) &&
          (best < 0 || last[layout].cost < last[best].cost))
        best = layout;
    std::vector<BedLayout> result(splits_.size());
    for (int i = end; i >= 0; --i) {
      const int of_split = flushes(splits_[i].slots());
      result[i] = flush_layout(splits_[i], best / of_split, best % of_split);
      if (i > 0) best = from_[i][best];
    }
    return result;
  }

  const std::vector<SlotMap>& maps_;
  RunContext* run_;
  std::vector<BedSplits> splits_;
  std::vector<std::vector<int>> from_;
  ShiftMeter meter_;
};

}  // namespace

std::vector<BedLayout> search_layouts(int slots, const std::vector<SlotMap>& maps,
                                      RunContext* run) {
  return LayoutSearch(slots, maps, run).run();
}

}  // namespace meshknit
