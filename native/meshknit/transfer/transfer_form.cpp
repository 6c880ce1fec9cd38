#include <algorithm>
#include <string>
#include <tuple>
#include <utility>

#include "meshknit/transfer/transfer_checks.h"

namespace meshknit {
namespace {

// Sorting hooks by this key walks the tube anticlockwise: front rightward, back leftward.
std::pair<int, int> anticlockwise_key(Bed bed, int place) {
  return bed == Bed::front ? std::make_pair(0, place) : std::make_pair(1, -place);
}

// A cyclic list is a rotation of a sorted one exactly if it steps down at most once on its way
// round.
template <class Key>
bool goes_round_once(const std::vector<TransferLoop>& loops, Key key) {
  int descents = 0;
  for (std::size_t i = 0; i < loops.size(); ++i)
    if (key(loops[i]) > key(loops[(i + 1) % loops.size()])) ++descents;
  return descents <= 1;
}

Problem malformed(std::string message, std::vector<int> loops = {}) {
  Problem problem;
  problem.code = "transfer-form";
  problem.message = std::move(message);
  problem.remedy =
      "Please report this: the layouts before and after the transfers do not fit each other.";
  problem.elements.stitches = std::move(loops);
  return problem;
}

}  // namespace

Problems check_transfer_form(const TransferProblem& problem) {
  Problems found;
  const std::vector<TransferLoop>& loops = problem.loops;
  if (problem.slack.size() != loops.size())
    found.push_back(malformed("There are " + std::to_string(loops.size()) + " loops but " +
                              std::to_string(problem.slack.size()) + " slacks."));
  if (problem.max_racking < 0) found.push_back(malformed("The racking limit is negative."));
  for (std::size_t i = 0; i < loops.size(); ++i) {
    const auto [low, high] = std::minmax(loops[i].from, loops[i].to);
    if (low < problem.lowest || high > problem.highest)
      found.push_back(malformed(
          "Loop " + std::to_string(i) + " starts or ends on a needle outside the range.",
          {static_cast<int>(i)}));
  }
  const auto from_key = [](const TransferLoop& l) {
    return anticlockwise_key(l.from_bed, l.from);
  };
  const auto to_key = [](const TransferLoop& l) { return anticlockwise_key(l.to_bed, l.to); };
  if (!goes_round_once(loops, from_key))
    found.push_back(
        malformed("The loops do not hang in anticlockwise order before the transfers."));
  if (!goes_round_once(loops, to_key))
    found.push_back(malformed("The loops' targets are not in anticlockwise order."));
  // In a rotation of a sorted list equal keys are neighbours.
  for (std::size_t i = 0; i < loops.size() && loops.size() > 1; ++i) {
    const std::size_t next = (i + 1) % loops.size();
    if (from_key(loops[i]) == from_key(loops[next]))
      found.push_back(malformed("Loops " + std::to_string(i) + " and " + std::to_string(next) +
                                    " start on one needle.",
                                {static_cast<int>(i), static_cast<int>(next)}));
  }
  return found;
}

}  // namespace meshknit
