#pragma once

#include <vector>

namespace meshknit {

/// A run of neighbouring nodes round a row: first to last, inclusive; `last` may be smaller
/// than `first` where the run passes the row's start.
struct NodeRun {
  int first = 0, last = 0;
  int size(int row) const { return (last - first + row) % row + 1; }
};

/// Which nodes of a next cycle are kept (paper, 3.2.2): all of them if the cycle lies after the
/// active one in time; otherwise those whose time is not later than `active_time`, in runs of
/// at least `fewest` nodes that lie at least `fewest` nodes apart. An empty result stands for
/// "all", also where no run is long enough.
std::vector<NodeRun> accept_by_time(const std::vector<double>& node_times, double active_time,
                                    int fewest);

}  // namespace meshknit
