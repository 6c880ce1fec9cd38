#include "meshknit/remesh/junction_links.h"

#include <limits>

namespace meshknit {

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
