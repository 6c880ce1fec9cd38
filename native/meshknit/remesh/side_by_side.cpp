#include "meshknit/remesh/side_by_side.h"

#include <algorithm>
#include <limits>
#include <map>
#include <utility>

namespace meshknit {
std::vector<PartStretch> side_by_side(const std::vector<int>& given,
                                      const std::vector<double>& weight, int parts,
                                      double least) {
  std::vector<int> part = given;
  const int n = static_cast<int>(part.size());
  const auto weigh = [&](const PartStretch& stretch) {
    double sum = 0.0;
    for (int i = 0; i < stretch.count; ++i) sum += weight[(stretch.first + i) % n];
    return sum;
  };
  for (;;) {
    const std::vector<PartStretch> all = ring_stretches(part);
    std::vector<double> weights;
    for (const PartStretch& stretch : all) weights.push_back(weigh(stretch));
    const auto lightest = std::min_element(weights.begin(), weights.end());
    if (all.size() < 2 || *lightest >= least) break;
    const std::size_t k = static_cast<std::size_t>(lightest - weights.begin());
    const std::size_t before = (k + all.size() - 1) % all.size(), after = (k + 1) % all.size();
    const int heavier = all[weights[before] < weights[after] ? after : before].part;
    for (int i = 0; i < all[k].count; ++i) part[(all[k].first + i) % n] = heavier;
  }
  std::vector<PartStretch> found = ring_parts(part);
  if (static_cast<int>(found.size()) != 2 * (parts - 1)) found.clear();
  return found;
}

std::vector<PartStretch> balance(const std::vector<PartStretch>& given,
                                 const std::vector<std::vector<double>>& cost, int fewest,
                                 int reach) {
  const int n = static_cast<int>(cost.front().size());
  const int parts = static_cast<int>(given.size()) / 2 + 1;
  // Places on the ring, counted on from the first stretch: a middle part's stretches end at `front`
  // and begin at `back`, which come towards each other.
  const int origin = given.front().first;
  std::vector<std::vector<double>> sum(parts, std::vector<double>(3 * n + 1, 0.0));
  for (int p = 0; p < parts; ++p)
    for (int i = 0; i < 3 * n; ++i) sum[p][i + 1] = sum[p][i] + cost[p][(origin + i) % n];
  // Ends may also move back past the origin: everything is a turn further on.
  const auto cost_of = [&](int p, int begin, int end) { return sum[p][end] - sum[p][begin]; };
  std::vector<int> front{n}, back{2 * n};  // where the parts after each end of a stretch begin
  for (int p = 1; p < parts; ++p) {
    front.push_back(front.back() + given[p - 1].count);
    if (p > 1) back.push_back(back.back() - given[given.size() - (p - 1)].count);
  }
  front.erase(front.begin());  // front[p]: end of part p's lower stretch, and back[p] likewise
  struct Ends {
    int front, back;
    bool operator<(const Ends& other) const {
      return front != other.front ? front < other.front : back < other.back;
    }
  };
  struct Way {
    double cost;
    Ends from;
  };
  std::vector<std::map<Ends, Way>> ways(parts - 1);
  for (int f = front[0] - reach; f <= front[0] + reach; ++f)
    for (int b = back[0] - reach; b <= back[0] + reach; ++b) {
      const int begin = b - n;
      // Middle parts are even. With both end parts odd, the even whole would not be aligned.
      if (f - begin < fewest || begin < 0 || (n % 2 == 0 && (f - begin) % 2 != 0)) continue;
      ways[0][{f, b}] = {cost_of(given[0].part, begin, f), {0, 0}};
    }
  for (int p = 1; p + 1 < parts; ++p) {
    const int part = given[p].part;
    for (const auto& [ends, way] : ways[p - 1])
      for (int f = std::max(front[p] - reach, ends.front + (fewest + 1) / 2);
           f <= front[p] + reach; ++f) {
        const int b = ends.back - (f - ends.front);
        if (b < back[p] - reach || b > back[p] + reach || b <= f) continue;
        const double all =
            way.cost + cost_of(part, ends.front, f) + cost_of(part, b, ends.back);
        const auto found = ways[p].find({f, b});
        if (found == ways[p].end() || all < found->second.cost) ways[p][{f, b}] = {all, ends};
      }
  }
  const int last = given[parts - 1].part;
  double least = std::numeric_limits<double>::infinity();
  Ends best{0, 0};
  for (const auto& [ends, way] : ways[parts - 2]) {
    if (ends.back - ends.front < fewest) continue;
    const double all = way.cost + cost_of(last, ends.front, ends.back);
    if (all < least) {
      least = all;
      best = ends;
    }
  }
  if (!(least < std::numeric_limits<double>::infinity())) return {};
  std::vector<PartStretch> balanced = given;
  const auto put = [&](std::size_t k, int begin, int end) {
    balanced[k].first = (origin + begin) % n;
    balanced[k].count = end - begin;
  };
  put(parts - 1, best.front, best.back);
  for (int p = parts - 2; p > 0; --p) {
    const Ends from = ways[p].at(best).from;
    put(p, from.front, best.front);
    put(given.size() - p, best.back, from.back);
    best = from;
  }
  put(0, best.back - n, best.front);
  return balanced;
}

}  // namespace meshknit
