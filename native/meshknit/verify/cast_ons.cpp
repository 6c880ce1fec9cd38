#include "meshknit/verify/cast_ons.h"

#include <algorithm>

namespace meshknit {

CastOns::CastOns(const Fabric& fabric, const std::vector<ExpectedLoop>& items,
                 const TraceColumns& traced)
    : fabric_(fabric), round_of_(fabric.loops.size(), -1) {
  int rounds = 0;
  for (std::size_t id = items.size(); id-- > 0;) {
    const Loop& loop = fabric.loops[id];
    if (items[id].stitch >= 0) {
      round_of_[id] = traced.cast_on[items[id].stitch];
    } else if (!is_object(loop) && loop.child >= 0) {
      round_of_[id] = round_of_[loop.child];
    }
    rounds = std::max(rounds, round_of_[id] + 1);
  }
  column_for_.assign(rounds, -1);
}

int CastOns::tube(int loop, const Tubes& tubes, const std::vector<int>& column_of) const {
  const auto tube_of = [&](int column) { return column >= 0 ? tubes.tube_of(column) : -1; };
  const int round = round_of_[loop];
  if (round >= 0) {
    const int begun = tube_of(column_for_[round]);
    if (begun >= 0) return begun;
  }
  const int previous = fabric_.loops[loop].previous;
  const int tube = previous >= 0 ? tube_of(column_of[previous]) : -1;
  if (tube < 0 || round < 0) return tube;
  const bool taken = std::any_of(column_for_.begin(), column_for_.end(), [&](int column) {
    return column >= 0 && tube_of(column) == tube;
  });
  return taken ? -1 : tube;
}

void CastOns::made(int loop, int column) {
  if (round_of_[loop] >= 0) column_for_[round_of_[loop]] = column;
}

}  // namespace meshknit
