#include "meshknit/knit_graph/split_layout.h"

#include <algorithm>
#include <cstdlib>
#include <map>
#include <set>

namespace meshknit {
namespace {

struct Spot {
  bool front = true;
  int needle = 0;
  friend bool operator==(Spot a, Spot b) { return a.front == b.front && a.needle == b.needle; }
  friend bool operator<(Spot a, Spot b) {
    return a.front != b.front ? a.front < b.front : a.needle < b.needle;
  }
};

using Cycle = std::vector<int>;

/// All tube shapes of n loops, without rotations: loop i's spot, the first loop leftmost on the
/// front. There are five for even n and four for odd n (paper, section 3.4).
std::vector<std::vector<Spot>> tube_shapes(int n) {
  std::vector<std::vector<Spot>> shapes;
  for (int front = 1; front < n; ++front) {
    const int back = n - front;
    for (int left = -1; left <= 1; ++left) {
      if (std::abs(front - (left + back)) > 1) continue;
      std::vector<Spot> shape;
      for (int i = 0; i < front; ++i) shape.push_back({true, i});
      for (int i = back; i-- > 0;) shape.push_back({false, left + i});
      shapes.push_back(std::move(shape));
    }
  }
  return shapes;
}

/// True if the spots run once round a tube without a gap.
bool is_tube(const std::vector<Spot>& spots) {
  int crossings = 0;
  for (std::size_t i = 0; i < spots.size(); ++i) {
    const Spot a = spots[i], b = spots[(i + 1) % spots.size()];
    const int step = b.needle - a.needle;
    if (a.front == b.front ? step != (a.front ? 1 : -1) : std::abs(step) > 1) return false;
    if (a.front != b.front) ++crossings;
  }
  return crossings == 2;
}

/// Depth-first search over the cycles' layouts.
class LayoutSearch {
 public:
  explicit LayoutSearch(std::vector<Cycle> cycles) : cycles_(std::move(cycles)) {}

  bool place_from(std::size_t k) {
    if (k == cycles_.size()) return true;
    const Cycle& cycle = cycles_[k];
    const int n = static_cast<int>(cycle.size());
    const auto known =
        std::find_if(cycle.begin(), cycle.end(), [&](int c) { return spots_.count(c) > 0; });
    if (std::all_of(cycle.begin(), cycle.end(), [&](int c) { return spots_.count(c) > 0; })) {
      std::vector<Spot> spots;
      for (const int column : cycle) spots.push_back(spots_.at(column));
      return is_tube(spots) && place_from(k + 1);
    }
    const int anchor = known == cycle.end() ? -1 : static_cast<int>(known - cycle.begin());
    for (const std::vector<Spot>& shape : tube_shapes(n)) {
      for (int rotation = 0; rotation < n; ++rotation) {
        const auto spot = [&](int i) { return shape[(i + rotation) % n]; };
        const int shift =
            anchor < 0 ? 0 : spots_.at(cycle[anchor]).needle - spot(anchor).needle;
        std::vector<int> added;
        bool fits = true;
        for (int i = 0; i < n && fits; ++i)
          fits = put(cycle[i], {spot(i).front, spot(i).needle + shift}, added);
        if (fits && place_from(k + 1)) return true;
        for (const int column : added) take_away(column);
      }
    }
    return false;
  }

 private:
  bool put(int column, Spot spot, std::vector<int>& added) {
    const auto found = spots_.find(column);
    if (found != spots_.end()) return found->second == spot;
    if (!occupied_.insert(spot).second) return false;
    spots_.emplace(column, spot);
    added.push_back(column);
    return true;
  }

  void take_away(int column) {
    occupied_.erase(spots_.at(column));
    spots_.erase(column);
  }

  std::vector<Cycle> cycles_;
  std::map<int, Spot> spots_;
  std::set<Spot> occupied_;
};

/// Longest cycle first, then always one that shares a column with those before: at a plain
/// split or merge that leaves nothing to choose after the first.
std::vector<Cycle> in_search_order(std::vector<Cycle> cycles) {
  std::vector<Cycle> order;
  std::set<int> known;
  while (!cycles.empty()) {
    const auto shares = [&](const Cycle& cycle) {
      return std::any_of(cycle.begin(), cycle.end(), [&](int c) { return known.count(c) > 0; });
    };
    const auto better = [&](const Cycle& a, const Cycle& b) {
      const bool a_shares = shares(a), b_shares = shares(b);
      return a_shares != b_shares ? b_shares : a.size() < b.size();
    };
    const auto next = std::max_element(cycles.begin(), cycles.end(), better);
    known.insert(next->begin(), next->end());
    order.push_back(std::move(*next));
    cycles.erase(next);
  }
  return order;
}

}  // namespace

bool has_common_layout(const std::vector<std::vector<int>>& cycles) {
  return LayoutSearch(in_search_order(cycles)).place_from(0);
}

}  // namespace meshknit
