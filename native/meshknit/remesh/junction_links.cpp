#include "meshknit/remesh/junction_links.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <utility>

namespace meshknit {

std::vector<NodeImage> images_across(const ActiveCycle& active, int source,
                                     const NextCycle& next) {
  const double length = active.cycle.length();
  std::vector<std::pair<double, int>> feet;  // place on the active cycle, crossing
  for (int i = 0; i < next.cycle.size(); ++i)
    if (next.source[i] == source) feet.push_back({next.foot[i], i});
  std::sort(feet.begin(), feet.end());
  std::vector<NodeImage> images;
  for (const ActiveNode& node : active.nodes) {
    NodeImage image;
    image.off = std::numeric_limits<double>::infinity();
    const auto after = std::lower_bound(feet.begin(), feet.end(), std::make_pair(node.place, -1));
    const std::size_t k = static_cast<std::size_t>(after - feet.begin());
    if (!feet.empty())
      for (const std::size_t near : {k % feet.size(), (k + feet.size() - 1) % feet.size()}) {
        const double off = around(feet[near].first, node.place, length);
        if (std::abs(off) >= image.off) continue;
        image.off = std::abs(off);
        image.place = next.cycle.arc[feet[near].second];
      }
    images.push_back(image);
  }
  return images;
}

Stretch best_stretch(const std::vector<double>& weights, int fewest) {
  const int n = static_cast<int>(weights.size());
  // Largest sum over stretches of fewest..n-fewest elements: sums from a start are differences of
  // running sums, so keep the smallest running sum among the starts in reach.
  std::vector<double> sum(2 * n + 1, 0.0);
  for (int i = 0; i < 2 * n; ++i) sum[i + 1] = sum[i] + weights[i % n];
  Stretch best;
  double most = -std::numeric_limits<double>::infinity();
  std::vector<int> starts;  // candidates with growing running sums
  std::size_t head = 0;
  for (int end = fewest; end <= 2 * n; ++end) {
    const int start = end - fewest;
    while (starts.size() > head && sum[starts.back()] >= sum[start]) starts.pop_back();
    starts.push_back(start);
    while (end - starts[head] > n - fewest) ++head;
    const double here = sum[end] - sum[starts[head]];
    if (starts[head] < n && here > most + 1e-9) {
      most = here;
      best = {starts[head], end - starts[head]};
    }
  }
  return best;
}

}  // namespace meshknit
