#include "meshknit/tracing/loop_ring.h"

namespace meshknit {

int LoopRing::add_alone() {
  const int loop = static_cast<int>(next_.size());
  next_.push_back(loop);
  previous_.push_back(loop);
  return loop;
}

int LoopRing::add_after(int loop) {
  const int added = add_alone();
  next_[added] = next_[loop];
  previous_[added] = loop;
  previous_[next_[loop]] = added;
  next_[loop] = added;
  return added;
}

void LoopRing::unlink(int loop) {
  next_[previous_[loop]] = next_[loop];
  previous_[next_[loop]] = previous_[loop];
}

void LoopRing::take_off(int loop) {
  unlink(loop);
  next_[loop] = previous_[loop] = -1;
}

void LoopRing::join(const std::vector<int>& loops) {
  for (const int loop : loops) {
    unlink(loop);
    next_[loop] = previous_[loop] = loop;
  }
  for (std::size_t i = 0; i < loops.size(); ++i) {
    const int after = loops[(i + 1) % loops.size()];
    next_[loops[i]] = after;
    previous_[after] = loops[i];
  }
}

}  // namespace meshknit
