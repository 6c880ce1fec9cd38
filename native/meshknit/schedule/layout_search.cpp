#include "meshknit/schedule/layout_search.h"

#include <algorithm>

#include "meshknit/core/error.h"
#include "meshknit/schedule/layout_cost.h"
#include "meshknit/schedule/roll_search.h"

namespace meshknit {
namespace {

struct Reached {
  ShiftCost cost;
  int from = -1;  // layout of the cycle before; -1: none
  bool reached = false;
};

class LayoutSearch {
 public:
  LayoutSearch(int slots, const std::vector<SlotMap>& maps, const LayoutLimits& limits,
               RunContext* run)
      : maps_(maps), limits_(limits), run_(run) {
    splits_.reserve(maps.size() + 1);
    splits_.emplace_back(slots);
    for (const SlotMap& map : maps) splits_.emplace_back(map.slots());
  }

  FoundLayouts run() {
    const RollTable rolls = search_rolls(
        splits_, maps_,
        {split_of(limits_.first, splits_.front()), split_of(limits_.last, splits_.back())},
        run_);
    from_.assign(splits_.size(), {});
    std::vector<Reached> reached(splits_[0].size() * flushes(splits_[0].slots()));
    for (size_t i = 0; i < reached.size(); ++i)
      reached[i].reached = may_be(limits_.first, splits_.front(), static_cast<int>(i));
    for (size_t i = 0; i < maps_.size(); ++i) {
      report(run_, static_cast<double>(i) / static_cast<double>(maps_.size()));
      reached = advance(i, reached, rolls);
    }
    return walk_back(reached, rolls);
  }

 private:
  // The layouts of one split that can be best: aligned for N even, flush at the left or at the
  // right for N odd.
  int flushes(int slots) const { return slots % 2 == 0 || limits_.beside_others ? 1 : 2; }

  BedLayout flush_layout(const BedSplits& splits, int split, int flush) const {
    BedLayout layout = splits.layout(split);
    const bool odd = layout.slots % 2 != 0, more_front = 2 * layout.shape.front > layout.slots;
    if (limits_.beside_others) {
      layout.shape.left = odd && !more_front ? -1 : 0;
    } else if (flush == 1) {
      layout.shape.left = more_front ? 1 : -1;
    }
    return layout;
  }

  static int split_of(const std::optional<BedLayout>& layout, const BedSplits& splits) {
    return layout ? splits.number_of(*layout) : -1;
  }

  // True if an end of the tube may have this layout.
  bool may_be(const std::optional<BedLayout>& wanted, const BedSplits& splits,
              int layout) const {
    if (!wanted) return true;
    const int ways = flushes(splits.slots());
    return layout / ways == splits.number_of(*wanted) &&
           flush_layout(splits, layout / ways, layout % ways).shape.left == wanted->shape.left;
  }

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
                if (!here[from].reached) continue;
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

  FoundLayouts walk_back(const std::vector<Reached>& last, const RollTable& rolls) const {
    const int end = static_cast<int>(splits_.size()) - 1;
    int best = -1;
    const int ways = flushes(splits_[end].slots());
    for (int layout = 0; layout < static_cast<int>(last.size()); ++layout)
      if (last[layout].reached && may_be(limits_.last, splits_[end], layout) &&
          rolls.on_best_way(end, layout / ways) &&
          (best < 0 || last[layout].cost < last[best].cost))
        best = layout;
    FoundLayouts result;
    result.rolls = rolls.fewest;
    result.moves = last[best].cost;
    result.layouts.resize(splits_.size());
    for (int i = end; i >= 0; --i) {
      const int of_split = flushes(splits_[i].slots());
      result.layouts[i] = flush_layout(splits_[i], best / of_split, best % of_split);
      if (i > 0) best = from_[i][best];
    }
    return result;
  }

  const std::vector<SlotMap>& maps_;
  const LayoutLimits& limits_;
  RunContext* run_;
  std::vector<BedSplits> splits_;
  std::vector<std::vector<int>> from_;
  ShiftMeter meter_;
};

}  // namespace

FoundLayouts search_layouts(int slots, const std::vector<SlotMap>& maps,
                            const LayoutLimits& limits, RunContext* run) {
  return LayoutSearch(slots, maps, limits, run).run();
}

}  // namespace meshknit
