#include "meshknit/schedule/layout_search.h"

#include <algorithm>

#include "meshknit/core/error.h"
#include "meshknit/schedule/layout_cost.h"
#include "meshknit/schedule/roll_search.h"

namespace meshknit {
namespace {

struct Reached {
  MoveCost cost;
  int from = -1;  // layout of the cycle before; -1: none
  bool reached = false;
};

/// The layouts of one cycle: shape by shape, each with every first slot.
class Cycle {
 public:
  Cycle(int slots, bool narrow) : slots_(slots) {
    for (const BedShape& shape : bed_shapes(slots)) {
      const BedLayout layout{slots, 0, shape, 0};
      const bool is_narrow = slots % 2 == 0 ? is_aligned(layout) : longest_bridge(layout) == 1;
      if (!narrow || is_narrow) shapes_.push_back(shape);
    }
  }

  int layouts() const { return static_cast<int>(shapes_.size()) * slots_; }
  BedLayout layout(int number) const {
    return {slots_, number % slots_, shapes_[number / slots_], 0};
  }
  /// Calls visit(number) for every layout of this split.
  template <typename Visit>
  void for_each(const BedLayout& split, Visit visit) const {
    for (std::size_t shape = 0; shape < shapes_.size(); ++shape)
      if (shapes_[shape].front == split.shape.front)
        visit(static_cast<int>(shape) * slots_ + split.first);
  }

 private:
  std::vector<BedShape> shapes_;
  int slots_;
};

bool may_be(const std::optional<BedLayout>& wanted, const BedLayout& layout) {
  return !wanted ||
         (wanted->first == layout.first && wanted->shape.front == layout.shape.front &&
          wanted->shape.left == layout.shape.left);
}

std::vector<BedSplits> splits_of(int slots, const std::vector<SlotMap>& maps) {
  std::vector<BedSplits> splits;
  splits.reserve(maps.size() + 1);
  splits.emplace_back(slots);
  for (const SlotMap& map : maps) splits.emplace_back(map.slots());
  return splits;
}

SplitEnds split_ends(const std::vector<BedSplits>& splits, const LayoutLimits& limits) {
  const auto split_of = [](const std::optional<BedLayout>& layout, const BedSplits& of) {
    return layout ? of.number_of(*layout) : -1;
  };
  return {split_of(limits.first, splits.front()), split_of(limits.last, splits.back())};
}

class LayoutSearch {
 public:
  LayoutSearch(int slots, const std::vector<SlotMap>& maps, const LayoutLimits& limits,
               RunContext* run)
      : maps_(maps), limits_(limits), run_(run) {
    splits_ = splits_of(slots, maps);
    for (const BedSplits& splits : splits_) cycles_.emplace_back(splits.slots(), limits.narrow);
  }

  FoundLayouts run() {
    const RollTable rolls = search_rolls(splits_, maps_, split_ends(splits_, limits_), run_);
    most_at_once_ = kRollsAtOnce;
    if (!maps_.empty()) most_at_once_ += rolls.fewest / static_cast<int>(maps_.size());
    for (; most_at_once_ < 2 * (rolls.fewest + kMoreRolls + kRollsAtOnce); most_at_once_ *= 2)
      if (const std::optional<FoundLayouts> found = search(rolls)) return *found;
    throw BrokenPromise("no layouts of a tube were found within the limits of their search");
  }

 private:
  std::optional<FoundLayouts> search(const RollTable& rolls) {
    from_.assign(cycles_.size(), {});
    std::vector<Reached> reached(cycles_[0].layouts());
    for (size_t i = 0; i < reached.size(); ++i)
      reached[i].reached = may_be(limits_.first, cycles_[0].layout(static_cast<int>(i)));
    for (size_t i = 0; i < maps_.size(); ++i) {
      report(run_, static_cast<double>(i) / static_cast<double>(maps_.size()));
      reached = advance(i, reached, rolls);
    }
    return walk_back(reached);
  }

  std::vector<Reached> advance(size_t i, const std::vector<Reached>& here,
                               const RollTable& rolls) {
    const BedSplits &before = splits_[i], &after = splits_[i + 1];
    std::vector<Reached> next(cycles_[i + 1].layouts());
    const std::vector<int>& to_end = rolls.to_end[i + 1];
    const int least_left = *std::min_element(to_end.begin(), to_end.end());
    for (int split = 0; split < before.size(); ++split) {
      const int left = rolls.fewest + kMoreRolls - rolls.from_start[i][split];
      if (left < rolls.to_end[i][split]) continue;
      const BedLayout from_split = before.layout(split);
      for_each_split_within(
          maps_[i], from_split, after, std::min(left - least_left, most_at_once_),
          [&](int to_split, int cost) {
            if (cost + to_end[to_split] > left) return;
            cycles_[i].for_each(from_split, [&](int from) {
              if (!here[from].reached) return;
              cycles_[i + 1].for_each(after.layout(to_split), [&](int to) {
                if (next[to].reached && next[to].cost < here[from].cost) return;
                const MoveCost total =
                    here[from].cost + meter_.measure(maps_[i], cycles_[i].layout(from),
                                                     cycles_[i + 1].layout(to));
                if (next[to].reached && !(total < next[to].cost)) return;
                next[to] = {total, from, true};
              });
            });
          });
    }
    from_[i + 1].reserve(next.size());
    for (const Reached& layout : next) from_[i + 1].push_back(layout.from);
    return next;
  }

  std::optional<FoundLayouts> walk_back(const std::vector<Reached>& last) const {
    const int end = static_cast<int>(cycles_.size()) - 1;
    int best = -1;
    for (int layout = 0; layout < static_cast<int>(last.size()); ++layout)
      if (last[layout].reached && may_be(limits_.last, cycles_[end].layout(layout)) &&
          (best < 0 || last[layout].cost < last[best].cost))
        best = layout;
    if (best < 0) return std::nullopt;
    FoundLayouts result;
    result.cost = last[best].cost;
    result.layouts.resize(cycles_.size());
    for (int i = end; i >= 0; --i) {
      result.layouts[i] = cycles_[i].layout(best);
      if (i > 0) best = from_[i][best];
    }
    return result;
  }

  const std::vector<SlotMap>& maps_;
  const LayoutLimits& limits_;
  RunContext* run_;
  std::vector<BedSplits> splits_;
  std::vector<Cycle> cycles_;
  std::vector<std::vector<int>> from_;
  MoveMeter meter_;
  int most_at_once_ = 0;  // rolls
};

}  // namespace

FoundLayouts search_layouts(int slots, const std::vector<SlotMap>& maps,
                            const LayoutLimits& limits, RunContext* run) {
  return LayoutSearch(slots, maps, limits, run).run();
}

long fewest_rolls(int slots, const std::vector<SlotMap>& maps, const LayoutLimits& limits,
                  RunContext* run) {
  const std::vector<BedSplits> splits = splits_of(slots, maps);
  return search_rolls(splits, maps, split_ends(splits, limits), run).fewest;
}

}  // namespace meshknit
