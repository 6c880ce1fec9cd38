#include "meshknit/verify/junction_queue.h"

#include <algorithm>

namespace meshknit {

JunctionQueue::JunctionQueue(const std::vector<Junction>& junctions)
    : done_(junctions.size(), false) {
  for (int j = 0; j < static_cast<int>(junctions.size()); ++j) {
    opened_by_.emplace(junctions[j].opens, j);
    due_.emplace(junctions[j].stitch, j);
  }
}

void JunctionQueue::made(int stitch) {
  const auto [begin, end] = opened_by_.equal_range(stitch);
  for (auto entry = begin; entry != end; ++entry) {
    const int junction = entry->second;
    if (done_[junction]) continue;
    const auto place = std::lower_bound(open_.begin(), open_.end(), junction);
    if (place == open_.end() || *place != junction) open_.insert(place, junction);
  }
}

int JunctionQueue::due(int stitch) const {
  const auto found = due_.find(stitch);
  return found == due_.end() || done_[found->second] ? -1 : found->second;
}

void JunctionQueue::done(int junction) {
  done_[junction] = true;
  open_.erase(std::remove(open_.begin(), open_.end(), junction), open_.end());
}

}  // namespace meshknit
