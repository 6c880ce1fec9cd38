#include "meshknit/transfer/transfer_problem.h"

#include <algorithm>
#include <cstdlib>

namespace meshknit {

std::vector<int> usual_slack(const std::vector<TransferLoop>& loops) {
  std::vector<int> slack;
  slack.reserve(loops.size());
  for (std::size_t i = 0; i < loops.size(); ++i) {
    const TransferLoop& a = loops[i];
    const TransferLoop& b = loops[(i + 1) % loops.size()];
    const int places = std::max({1, std::abs(a.from - b.from), std::abs(a.to - b.to)});
    slack.push_back(2 * places + 1);
  }
  return slack;
}

int count_passes(const TransferPlan& plan) {
  int passes = 0;
  const Transfer* before = nullptr;
  for (const Transfer& transfer : plan.transfers) {
    if (!before || before->from.bed != transfer.from.bed ||
        racking_of(*before) != racking_of(transfer))
      ++passes;
    before = &transfer;
  }
  return passes;
}

}  // namespace meshknit
