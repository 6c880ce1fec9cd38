#include "meshknit/schedule/roll_search.h"

#include <cstdlib>
#include <utility>

#include "meshknit/core/error.h"

namespace meshknit {
namespace {

constexpr int kUnreached = 1 << 28;

// No move between two cycles can do with fewer rolls than the least difference in size of its
// front beds.
int fewest_rolls_of_move(const SlotMap& map, const BedSplits& before, const BedSplits& after) {
  int fewest = kUnreached;
  for (int split = 0; split < after.size(); ++split) {
    const BedLayout layout = after.layout(split);
    const int front =
        map.first_stack(layout.first + layout.shape.front) - map.first_stack(layout.first);
    for (int f = 0; f < before.fronts(); ++f)
      fewest =
          std::min(fewest, std::abs(front - before.layout(f * before.slots()).shape.front));
  }
  return fewest;
}

class RollSearch {
 public:
  RollSearch(const std::vector<BedSplits>& splits, const std::vector<SlotMap>& maps,
             RunContext* run)
      : splits_(splits), maps_(maps), run_(run), still_needed_(splits.size(), 0) {
    for (size_t i = maps.size(); i-- > 0;)
      still_needed_[i] =
          still_needed_[i + 1] + fewest_rolls_of_move(maps[i], splits[i], splits[i + 1]);
  }

  // Looks at all ways that cost at most a limit, and raises the limit until there is one.
  RollTable run() {
    for (int spare = 4; !forward(still_needed_[0] + spare); spare *= 2) {
    }
    backward();
    return std::move(table_);
  }

 private:
  // Rolls that the move from a split may cost so that the whole way can stay within the limit.
  int allowance(size_t cycle, int split) const {
    return limit_ - table_.from_start[cycle][split] - still_needed_[cycle + 1];
  }

  bool forward(int limit) {
    limit_ = limit;
    table_.from_start.assign(splits_.size(), {});
    table_.from_start[0].assign(splits_[0].size(), 0);
    for (size_t i = 0; i < maps_.size(); ++i) {
      if (run_ && run_->cancelled()) throw Cancelled();
      std::vector<int>& next = table_.from_start[i + 1];
      next.assign(splits_[i + 1].size(), kUnreached);
      for (int split = 0; split < splits_[i].size(); ++split) {
        const int from = table_.from_start[i][split];
        if (from == kUnreached) continue;
        for_each_split_within(
            maps_[i], splits_[i].layout(split), splits_[i + 1], allowance(i, split),
            [&](int to, int rolls) { next[to] = std::min(next[to], from + rolls); });
      }
    }
    const std::vector<int>& last = table_.from_start.back();
    table_.fewest = *std::min_element(last.begin(), last.end());
    return table_.fewest != kUnreached;
  }

  void backward() {
    table_.to_end.assign(splits_.size(), {});
    table_.to_end.back().assign(splits_.back().size(), 0);
    for (size_t i = maps_.size(); i-- > 0;) {
      const std::vector<int>& next = table_.to_end[i + 1];
      std::vector<int>& here = table_.to_end[i];
      here.assign(splits_[i].size(), kUnreached);
      for (int split = 0; split < splits_[i].size(); ++split) {
        if (table_.from_start[i][split] == kUnreached) continue;
        for_each_split_within(
            maps_[i], splits_[i].layout(split), splits_[i + 1], allowance(i, split),
            [&](int to, int rolls) { here[split] = std::min(here[split], rolls + next[to]); });
      }
    }
  }

  const std::vector<BedSplits>& splits_;
  const std::vector<SlotMap>& maps_;
  RunContext* run_;
  std::vector<int> still_needed_;
  RollTable table_;
  int limit_ = 0;
};

}  // namespace

BedSplits::BedSplits(int slots) : slots_(slots) {
  for (const BedShape& shape : bed_shapes(slots)) {
    const bool balanced = std::abs(slots - 2 * shape.front) <= 1;
    const bool known = std::find(front_.begin(), front_.end(), shape.front) != front_.end();
    if (balanced && !known) front_.push_back(shape.front);
  }
}

RollTable search_rolls(const std::vector<BedSplits>& splits, const std::vector<SlotMap>& maps,
                       RunContext* run) {
  return RollSearch(splits, maps, run).run();
}

}  // namespace meshknit
