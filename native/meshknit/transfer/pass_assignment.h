#pragma once

#include <algorithm>
#include <limits>
#include <optional>
#include <utility>
#include <vector>

#include "meshknit/transfer/itinerary.h"

namespace meshknit {

/// A way through the same passes for every stack of a tube.
struct Assignment {
  std::vector<Itinerary> ways;  ///< one a stack
  long cost = 0;
};

/// Given a sequence of passes, who moves when? Neighbours restrict only each other, so the best
/// choice for the whole tube is a cheapest closed walk round it: dynamic programming over the
/// blocks, linear in their number.
class PassAssigner {
 public:
  explicit PassAssigner(const Tube& tube) : tube_(tube), blocks_(cut_into_blocks(tube)) {}

  /// Every stack to its goal with the fewest transfers; none if the passes do not allow it.
  std::optional<Assignment> to_goals(const Passes& passes);

  /// Every stack to some hook, such that the sum of `penalty(stack, last stop)` is least, then
  /// with the fewest transfers; none if that costs `limit` or more.
  template <class Penalty>
  std::optional<Assignment> towards_goals(const Passes& passes, Penalty penalty, long limit) {
    return assign(passes, Ending::any_hook, limit,
                  [&](const Block& block, const Itinerary& way) {
                    const Stop& end = way.stops[passes.size()];
                    long sum = 0;
                    for (int i = block.first; i <= block.last; ++i) {
                      Stop stop = end;
                      stop.place += tube_.stacks[i].place - tube_.stacks[block.first].place;
                      sum += penalty(tube_.stacks[i], stop);
                    }
                    return sum * one_penalty + static_cast<long>(way.transfers) * block.size();
                  });
  }

  /// Costs of `towards_goals` count this much for each unit of penalty, and 1 for each
  /// transfer.
  static constexpr long one_penalty = 1L << 24;

 private:
  using Ways = std::vector<Itinerary>;
  using Allowed = std::vector<char>;  // [way of a block * ways of the next + way of the next]

  template <class Cost>
  std::optional<Assignment> assign(const Passes& passes, Ending ending, long limit, Cost cost) {
    forget_ways();
    // The first pair to ask is the one that refused last: most sequences fail there.
    if (!list_allowed_after(last_refusal_, passes, ending)) return std::nullopt;
    std::vector<std::vector<long>> costs(blocks_.size());
    long least = 0;  // as if neighbours did not matter
    for (std::size_t b = 0; b < blocks_.size() && least < limit; ++b) {
      for (const Itinerary& way : ways_of(b, passes, ending))
        costs[b].push_back(cost(blocks_[b], way));
      if (costs[b].empty()) return std::nullopt;
      least += *std::min_element(costs[b].begin(), costs[b].end());
    }
    if (least >= limit || !list_allowed(passes, ending)) return std::nullopt;
    std::optional<Assignment> best = cheapest_round(costs);
    return best && best->cost < limit ? best : std::nullopt;
  }

  void forget_ways();
  bool list_allowed(const Passes& passes, Ending ending);
  bool list_allowed_after(std::size_t block, const Passes& passes, Ending ending);
  const Ways& ways_of(std::size_t block, const Passes& passes, Ending ending);
  std::optional<Assignment> cheapest_round(const std::vector<std::vector<long>>& costs) const;

  const Tube& tube_;
  std::vector<Block> blocks_;
  std::vector<Ways> ways_;  // filled when first asked for; the first pair may refuse already
  std::vector<char> has_ways_;
  std::vector<Allowed> allowed_;  // from each block to the next
  std::size_t last_refusal_ = 0;  // the block whose pair refused last: it is asked first
};

/// The transfers of an assignment in an order that can be done: loops that go round an end
/// leave it from outside inwards.
void append_transfers(const Tube& tube, const Passes& passes, const Assignment& assignment,
                      TransferPlan& plan);

}  // namespace meshknit
