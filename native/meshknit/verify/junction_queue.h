#pragma once

#include <map>
#include <vector>

#include "meshknit/verify/trace_columns.h"

namespace meshknit {

/// Which junctions of a trace may happen, as its stitches are made one after another. A junction
/// is open from the stitch after which no yarn needs the old neighbours; it is due when its own
/// stitch is about to be made.
class JunctionQueue {
 public:
  explicit JunctionQueue(const std::vector<Junction>& junctions);

  void made(int stitch);
  /// Open junctions that are not done, in their order.
  const std::vector<int>& open() const { return open_; }
  /// The junction that this stitch needs and that is not done; -1 for none.
  int due(int stitch) const;
  void done(int junction);

 private:
  std::multimap<int, int> opened_by_;  // stitch -> junctions
  std::map<int, int> due_;             // stitch -> junction
  std::vector<bool> done_;
  std::vector<int> open_;
};

}  // namespace meshknit
