#include "meshknit/tracing/seam_choice.h"

#include <algorithm>
#include <utility>

#include "meshknit/tracing/hanging_order.h"

namespace meshknit {
namespace {

constexpr std::size_t kMostForAllSets = 12;

class SeamSearch {
 public:
  SeamSearch(const std::vector<TubeLinks>& tubes, const std::vector<int>& stitches)
      : tubes_(tubes), stitches_(stitches) {
    // A tube that starts or ends the object hangs no better in two pieces.
    for (int tube = 0; tube < static_cast<int>(tubes.size()); ++tube)
      if (stitches[tube] > 0 && !tubes[tube].below.empty() && !tubes[tube].above.empty())
        candidates_.push_back(tube);
  }

  std::vector<int> run() const {
    if (!helps(candidates_)) return {};
    const bool all_sets = candidates_.size() <= kMostForAllSets;
    for (std::size_t size = 1; size <= (all_sets ? candidates_.size() : 2); ++size)
      for (const auto& [stitches, set] : sets_of(size))
        if (helps(set)) return set;
    return take_back();
  }

 private:
  using Set = std::vector<int>;

  bool helps(const Set& set) const {
    return find_hanging_order(cut_tubes(tubes_, set)).verdict == HangingOrder::Verdict::found;
  }

  // With their stitches, fewest first.
  std::vector<std::pair<int, Set>> sets_of(std::size_t size) const {
    std::vector<bool> taken(candidates_.size(), false);
    std::fill(taken.begin(), taken.begin() + static_cast<long>(size), true);
    std::vector<std::pair<int, Set>> sets;
    do {
      std::pair<int, Set> set{0, {}};
      for (std::size_t i = 0; i < candidates_.size(); ++i)
        if (taken[i]) {
          set.first += stitches_[candidates_[i]];
          set.second.push_back(candidates_[i]);
        }
      sets.push_back(std::move(set));
    } while (std::prev_permutation(taken.begin(), taken.end()));
    std::sort(sets.begin(), sets.end());
    return sets;
  }

  Set take_back() const {
    Set dearest_first = candidates_;
    std::stable_sort(dearest_first.begin(), dearest_first.end(),
                     [&](int a, int b) { return stitches_[a] > stitches_[b]; });
    Set set = candidates_;
    for (const int tube : dearest_first) {
      Set fewer = set;
      fewer.erase(std::find(fewer.begin(), fewer.end(), tube));
      if (helps(fewer)) set = std::move(fewer);
    }
    return set;
  }

  const std::vector<TubeLinks>& tubes_;
  const std::vector<int>& stitches_;
  Set candidates_;
};

}  // namespace

std::vector<TubeLinks> cut_tubes(std::vector<TubeLinks> tubes, const std::vector<int>& cut) {
  for (const int tube : cut) {
    const int upper = static_cast<int>(tubes.size());
    const double middle = 0.5 * (tubes[tube].begin + tubes[tube].end);
    tubes.push_back({{}, std::move(tubes[tube].above), middle, tubes[tube].end});
    tubes[tube].above.clear();
    tubes[tube].end = middle;
    for (const int above : tubes[upper].above) {
      std::vector<int>& below = tubes[above].below;
      std::replace(below.begin(), below.end(), tube, upper);
    }
  }
  return tubes;
}

SeamChoice choose_seams(const std::vector<TubeLinks>& tubes, const std::vector<int>& stitches) {
  if (can_hang(tubes)) return {};
  return {true, SeamSearch(tubes, stitches).run()};
}

}  // namespace meshknit
