#include "meshknit/remesh/acceptance.h"

#include <algorithm>

namespace meshknit {
namespace {

// Runs of `wanted` round a row; empty if the whole row is or none is.
std::vector<NodeRun> runs_of(const std::vector<char>& kept, char wanted) {
  const int n = static_cast<int>(kept.size());
  std::vector<NodeRun> runs;
  for (int i = 0; i < n; ++i) {
    if (kept[i] != wanted || kept[(i + n - 1) % n] == wanted) continue;
    int last = i;
    while (kept[(last + 1) % n] == wanted) last = (last + 1) % n;
    runs.push_back({i, last});
  }
  return runs;
}

void mark(std::vector<char>& kept, const NodeRun& run, char value) {
  const int n = static_cast<int>(kept.size());
  for (int k = 0; k < run.size(n); ++k) kept[(run.first + k) % n] = value;
}

}  // namespace

std::vector<NodeRun> accept_by_time(const std::vector<double>& node_times,
                                    const std::vector<double>& node_gains, double active_time,
                                    int fewest, int worthwhile) {
  const int n = static_cast<int>(node_times.size());
  std::vector<char> kept(n);
  for (int i = 0; i < n; ++i) kept[i] = node_times[i] <= active_time;
  const auto two_rows_late = [&](const NodeRun& run) {
    for (int k = 0; k < run.size(n); ++k) {
      const int i = (run.first + k) % n;
      if (node_times[i] + node_gains[i] <= active_time) return true;
    }
    return false;
  };
  // First drop short runs, then close short gaps: a gap must have room for the turns on both of
  // its sides.
  for (const NodeRun& run : runs_of(kept, 1))
    if (run.size(n) < fewest || (run.size(n) < worthwhile && !two_rows_late(run)))
      mark(kept, run, 0);
  for (const NodeRun& gap : runs_of(kept, 0))
    if (gap.size(n) < fewest) mark(kept, gap, 1);
  return runs_of(kept, 1);
}

}  // namespace meshknit
