#include "meshknit/transfer/pass_assignment.h"

#include <algorithm>

namespace meshknit {
namespace {

constexpr long impossible = -1;

}  // namespace

std::optional<Assignment> PassAssigner::to_goals(const Passes& passes) {
  return assign(passes, Ending::goal, std::numeric_limits<long>::max(),
                [](const Block& block, const Itinerary& way) {
                  return static_cast<long>(way.transfers) * block.size();
                });
}

const PassAssigner::Ways& PassAssigner::ways_of(std::size_t block, const Passes& passes,
                                                Ending ending) {
  if (!has_ways_[block]) {
    ways_[block] = itineraries(tube_, blocks_[block], passes, ending);
    has_ways_[block] = true;
  }
  return ways_[block];
}

void PassAssigner::forget_ways() {
  allowed_.resize(blocks_.size());
  ways_.resize(blocks_.size());
  has_ways_.assign(blocks_.size(), false);
}

bool PassAssigner::list_allowed(const Passes& passes, Ending ending) {
  for (std::size_t b = 0; b < blocks_.size(); ++b) {
    if (b == last_refusal_ || list_allowed_after(b, passes, ending)) continue;
    last_refusal_ = b;
    return false;
  }
  return true;
}

// Fills the table of the pair (last stack of a block, first stack of the next); false if
// nothing goes.
bool PassAssigner::list_allowed_after(std::size_t block, const Passes& passes, Ending ending) {
  const std::size_t next = block + 1 == blocks_.size() ? 0 : block + 1;
  const Stack& a = tube_.stacks[blocks_[block].last];
  const Stack& b = tube_.stacks[blocks_[next].first];
  const int turn = next == 0 ? 2 : 0;
  const int reach = a.place - tube_.stacks[blocks_[block].first].place;
  const Ways& ways_a = ways_of(block, passes, ending);
  const Ways& ways_b = ways_of(next, passes, ending);
  Allowed& allowed = allowed_[block];
  allowed.clear();
  bool any = false;
  for (const Itinerary& way : ways_a) {
    const Itinerary way_a = beside(way, reach);
    for (const Itinerary& way_b : ways_b) {
      const bool good = compatible(a, way_a, b, way_b, turn, passes);
      any = any || good;
      allowed.push_back(good);
    }
  }
  return any;
}

std::optional<Assignment> PassAssigner::cheapest_round(
    const std::vector<std::vector<long>>& costs) const {
  const std::size_t count = blocks_.size();
  // The walk is closed by trying every way of one block; the one with the fewest is cheapest.
  std::size_t seam = 0;
  for (std::size_t b = 1; b < count; ++b)
    if (ways_[b].size() < ways_[seam].size()) seam = b;

  long best_cost = impossible;
  std::vector<std::size_t> best_choice;
  for (std::size_t start = 0; start < ways_[seam].size(); ++start) {
    // reached[k][w]: least cost of k steps from the seam that end with way w; came_from
    // likewise.
    std::vector<long> reached(ways_[seam].size(), impossible);
    reached[start] = 0;
    std::vector<std::vector<std::size_t>> came_from(count);
    for (std::size_t k = 0; k < count; ++k) {
      const std::size_t b = (seam + k) % count, next = (b + 1) % count;
      std::vector<long> then(ways_[next].size(), impossible);
      came_from[k].resize(then.size());
      for (std::size_t v = 0; v < reached.size(); ++v) {
        if (reached[v] == impossible) continue;
        for (std::size_t w = 0; w < then.size(); ++w) {
          if (!allowed_[b][v * then.size() + w]) continue;
          const long cost = reached[v] + costs[next][w];
          if (then[w] != impossible && then[w] <= cost) continue;
          then[w] = cost;
          came_from[k][w] = v;
        }
      }
      reached = std::move(then);
    }
    const long cost = reached[start];
    if (cost == impossible || (best_cost != impossible && best_cost <= cost)) continue;
    best_cost = cost;
    best_choice.assign(count, start);
    std::size_t way = start;
    for (std::size_t k = count; k-- > 0;) {
      way = came_from[k][way];
      best_choice[(seam + k) % count] = way;
    }
  }
  if (best_cost == impossible) return std::nullopt;

  Assignment assignment;
  assignment.cost = best_cost;
  for (std::size_t b = 0; b < count; ++b)
    for (int i = blocks_[b].first; i <= blocks_[b].last; ++i)
      assignment.ways.push_back(
          beside(ways_[b][best_choice[b]],
                 tube_.stacks[i].place - tube_.stacks[blocks_[b].first].place));
  return assignment;
}

void append_transfers(const Tube& tube, const Passes& passes, const Assignment& assignment,
                      TransferPlan& plan) {
  struct Move {
    Stop from, to;
    // Right ends are left rightmost first, everything else leftmost first.
    bool round_right_end() const {
      return to.side != from.side &&
             (bed_of_side(from.side) == Bed::front) == (to.side > from.side);
    }
    std::pair<int, bool> order() const {
      return {round_right_end() ? -from.place : from.place, from.parked};
    }
  };
  for (std::size_t k = 0; k < passes.size(); ++k) {
    std::vector<Move> moves;
    for (std::size_t i = 0; i < tube.stacks.size(); ++i) {
      const Stop &from = assignment.ways[i].stops[k], &to = assignment.ways[i].stops[k + 1];
      if (!(from == to)) moves.push_back({from, to});
    }
    std::stable_sort(moves.begin(), moves.end(),
                     [](const Move& a, const Move& b) { return a.order() < b.order(); });
    // Stacks that came together on the way are moved as one.
    const auto one_stack = [](const Move& a, const Move& b) { return a.order() == b.order(); };
    moves.erase(std::unique(moves.begin(), moves.end(), one_stack), moves.end());
    for (const Move& move : moves)
      plan.transfers.push_back({{move.from.bed(), move.from.place, move.from.parked},
                                {move.to.bed(), move.to.place, move.to.parked}});
  }
}

}  // namespace meshknit
