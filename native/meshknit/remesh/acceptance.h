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
///
/// `node_gains`: how much time each node gains over the row below. A run of fewer nodes than
/// `worthwhile` waits until it is two rows late (its time and gain together are not later than
/// `active_time`): a turn costs a tuck and a small gap, and mostly the rows that follow make
/// one long run of several short ones.
std::vector<NodeRun> accept_by_time(const std::vector<double>& node_times,
                                    const std::vector<double>& node_gains, double active_time,
                                    int fewest, int worthwhile);

}  // namespace meshknit
