#include "meshknit/knit_graph/ring_parts.h"

#include <algorithm>
#include <numeric>

namespace meshknit {

std::vector<PartStretch> ring_stretches(const std::vector<int>& part) {
  const int n = static_cast<int>(part.size());
  int begin = 0;
  while (begin < n && part[begin] == part[(begin + n - 1) % n]) ++begin;
  std::vector<PartStretch> stretches;
  for (int i = 0; i < n; ++i) {
    const int at = (begin + i) % n;
    if (stretches.empty() || stretches.back().part != part[at])
      stretches.push_back({part[at], at, 0});
    ++stretches.back().count;
  }
  return stretches;
}

std::vector<PartStretch> ring_parts(const std::vector<int>& part) {
  std::vector<PartStretch> stretches = ring_stretches(part);
  if (stretches.size() < 2) return {};
  const auto times = [&](const PartStretch& stretch) {
    return std::count_if(stretches.begin(), stretches.end(),
                         [&](const PartStretch& other) { return other.part == stretch.part; });
  };
  auto left = stretches.end();
  for (auto at = stretches.begin(); at != stretches.end(); ++at)
    if (times(*at) == 1 && (left == stretches.end() || at->part < left->part)) left = at;
  if (left == stretches.end()) return {};
  std::rotate(stretches.begin(), left, stretches.end());
  // Going round from the left part, the parts come back in the opposite order.
  const std::size_t count = stretches.size();
  for (std::size_t k = 1; k < count; ++k) {
    if (stretches[k].part != stretches[count - k].part) return {};
    if (times(stretches[k]) != (2 * k == count ? 1 : 2)) return {};
  }
  return stretches;
}

std::vector<int> aligned_ends(const std::vector<int>& sizes, int left) {
  std::vector<int> ends{left};
  for (const int size : sizes) {
    if (size % 2 == 0 && ends.back() != 0) return {};
    ends.push_back(size % 2 == 0 ? 0 : -1 - ends.back());
  }
  const bool even = std::accumulate(sizes.begin(), sizes.end(), 0) % 2 == 0;
  if (even && (ends.front() != 0 || ends.back() != 0)) return {};
  return ends;
}

}  // namespace meshknit
