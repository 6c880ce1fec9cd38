#include "meshknit/schedule/roll_search.h"

#include "meshknit/core/error.h"

namespace meshknit {
namespace {

constexpr int kUnreached = 1 << 28;

// Rolls between two splits, as a distance. A split is the pair of gaps (x, y) round the tube at
// which the front bed begins and ends. Rolling one loop moves one of the gaps by one, so rolls
// are |x - X| + |y - Y|: with front beds of sizes F and Y - X this is |X - Z| + 2 dist(x, [X,
// Z]) for Z = Y - F. Only if the two front (or the two back) beds have no loop in common can it
// be less, namely the sum of their sizes, which is never less than the rolls.
class SplitDistance {
 public:
  SplitDistance(const SlotMap& map, const BedSplits& before, const BedSplits& after)
      : map_(map), before_(before), after_(after) {}

  /// Fewest rolls to every split of `after`, from those to every split of `before`.
  std::vector<int> forward(const std::vector<int>& from) const {
    const int n = before_.slots();
    std::vector<int> result(after_.size(), kUnreached);
    for (int f = 0; f < before_.fronts(); ++f) {
      std::vector<int> near(from.begin() + f * n, from.begin() + (f + 1) * n);
      const int least = *std::min_element(near.begin(), near.end());
      spread(near);
      for (int split = 0; split < after_.size(); ++split) {
        const Gaps gaps = gaps_of(split, f);
        int rolls = kUnreached;
        for (int x = gaps.begin; x <= gaps.end; ++x)
          rolls = std::min(rolls, near[wrapped(x, n)]);
        rolls = std::min(rolls + gaps.end - gaps.begin, least + gaps.nothing_kept);
        result[split] = std::min(result[split], rolls);
      }
    }
    return result;
  }

  /// Fewest rolls from every split of `before` to the end, given those from every split of
  /// `after`.
  std::vector<int> backward(const std::vector<int>& to_end) const {
    const int n = before_.slots();
    std::vector<int> result;
    for (int f = 0; f < before_.fronts(); ++f) {
      std::vector<int> near(n, kUnreached);
      int least = kUnreached;
      for (int split = 0; split < after_.size(); ++split) {
        const Gaps gaps = gaps_of(split, f);
        const int rolls = to_end[split] + gaps.end - gaps.begin;
        for (int x = gaps.begin; x <= gaps.end; ++x)
          near[wrapped(x, n)] = std::min(near[wrapped(x, n)], rolls);
        least = std::min(least, to_end[split] + gaps.nothing_kept);
      }
      spread(near);
      for (const int rolls : near) result.push_back(std::min(rolls, least));
    }
    return result;
  }

 private:
  struct Gaps {
    int begin, end;    // X and Z in order, at most a turn apart
    int nothing_kept;  // rolls if no loop stays on the front bed, or none on the back bed
  };

  static int wrapped(int x, int n) { return ((x % n) + n) % n; }

  // Lowers every entry to what a neighbour offers at two rolls a place, round the tube.
  static void spread(std::vector<int>& near) {
    const size_t n = near.size();
    for (size_t i = 1; i < 2 * n; ++i)
      near[i % n] = std::min(near[i % n], near[(i - 1) % n] + 2);
    for (size_t i = 2 * n; i-- > 1;)
      near[(i - 1) % n] = std::min(near[(i - 1) % n], near[i % n] + 2);
  }

  Gaps gaps_of(int split, int front_index) const {
    const BedLayout layout = after_.layout(split);
    const int n = before_.slots();
    const int front = before_.layout(before_.number(front_index, 0)).shape.front;
    const int x = map_.first_stack(layout.first);
    const int y = map_.first_stack(layout.first + layout.shape.front);
    const int z = y - front;
    return {std::min(x, z), std::max(x, z),
            std::min(front + (y - x), (n - front) + (n - (y - x)))};
  }

  const SlotMap& map_;
  const BedSplits &before_, &after_;
};

}  // namespace

BedSplits::BedSplits(int slots) : slots_(slots) {
  for (const BedShape& shape : bed_shapes(slots)) {
    const bool known = std::find(front_.begin(), front_.end(), shape.front) != front_.end();
    if (!known) front_.push_back(shape.front);
  }
}

RollTable search_rolls(const std::vector<BedSplits>& splits, const std::vector<SlotMap>& maps,
                       const SplitEnds& ends, RunContext* run) {
  const auto begin_with = [](const BedSplits& cycle, int wanted) {
    std::vector<int> rolls(cycle.size(), wanted < 0 ? 0 : kUnreached);
    if (wanted >= 0) rolls[wanted] = 0;
    return rolls;
  };
  RollTable table;
  table.from_start.push_back(begin_with(splits.front(), ends.first));
  for (size_t i = 0; i < maps.size(); ++i) {
    if (run && run->cancelled()) throw Cancelled();
    table.from_start.push_back(
        SplitDistance(maps[i], splits[i], splits[i + 1]).forward(table.from_start[i]));
  }
  table.to_end.resize(splits.size());
  table.to_end.back() = begin_with(splits.back(), ends.last);
  for (size_t i = maps.size(); i-- > 0;) {
    if (run && run->cancelled()) throw Cancelled();
    table.to_end[i] =
        SplitDistance(maps[i], splits[i], splits[i + 1]).backward(table.to_end[i + 1]);
  }
  const std::vector<int>& to_end = table.to_end.front();
  table.fewest = kUnreached;
  for (int split = 0; split < splits.front().size(); ++split)
    table.fewest = std::min(table.fewest, table.from_start.front()[split] + to_end[split]);
  return table;
}

}  // namespace meshknit
