#include "meshknit/transfer/pass_sequences.h"

#include <algorithm>
#include <map>

#include "meshknit/transfer/itinerary.h"
#include "meshknit/transfer/reach.h"

namespace meshknit {
namespace {

std::vector<Reach> distinct_reaches(const Tube& tube) {
  std::map<std::vector<int>, Reach> distinct;
  for (const Stack& stack : tube.stacks) distinct.emplace(Reach::key(stack), Reach(stack));
  std::vector<Reach> reaches;
  for (const auto& entry : distinct) reaches.push_back(entry.second);
  return reaches;
}

void sort_by_travel(std::vector<Passes>& sequences) {
  std::vector<std::pair<int, std::size_t>> order;
  for (std::size_t i = 0; i < sequences.size(); ++i)
    order.emplace_back(racking_travel(sequences[i]), i);
  std::sort(order.begin(), order.end());
  std::vector<Passes> sorted;
  sorted.reserve(sequences.size());
  for (const auto& entry : order) sorted.push_back(std::move(sequences[entry.second]));
  sequences = std::move(sorted);
}

// Of one kind of pair: the states in which it may be after the passes so far.
using States = std::vector<int>;

}  // namespace

PassSequences::PassSequences(const Tube& tube, PairWaysCache& cache)
    : max_racking_(std::min(tube.max_racking, PairWays::most_racking)) {
  for (const Stack& stack : tube.stacks) rolls_ += stack.roll() != 0;
  std::map<std::vector<int>, const PairWays*> kinds;
  const std::vector<Block> blocks = cut_into_blocks(tube);
  for (std::size_t i = 0; i < blocks.size(); ++i) {
    const bool closes = i + 1 == blocks.size();
    const Stack& a = tube.stacks[blocks[i].last];
    const Stack& b = tube.stacks[blocks[closes ? 0 : i + 1].first];
    const int turn = closes ? 2 : 0;
    kinds.emplace(PairWays::key(a, b, turn, max_racking_),
                  &cache.ways(a, b, turn, max_racking_));
  }
  for (const auto& kind : kinds) {
    pairs_.push_back(kind.second);
    seen_.emplace_back(kind.second->size(), 0);
  }
}

int PassSequences::least_length() const {
  int least = 0;
  for (const PairWays* pair : pairs_) least = std::max(least, pair->passes_home(0));
  return least;
}

std::vector<Passes> PassSequences::of_length(int length) {
  looked_at_ = 0;
  found_.clear();
  passes_.clear();
  states_.assign(length + 1, std::vector<States>(pairs_.size()));
  for (States& states : states_[0]) states = {0};
  extend(length, rolls_);
  sort_by_travel(found_);
  return found_;
}

void PassSequences::extend(int length, int rolls_left) {
  const std::size_t depth = passes_.size();
  const int left = length - static_cast<int>(depth);
  if (left == 0) {
    found_.push_back(passes_);
    return;
  }
  const std::uint32_t allowed = allowed_passes(depth, left);
  for (const Bed from : {Bed::front, Bed::back}) {
    for (int racking = -max_racking_; racking <= max_racking_; ++racking) {
      const Pass pass{from, racking};
      const int number = PairWays::number(pass);
      if (((allowed >> number) & 1) == 0 || (changes_side(pass) && rolls_left == 0)) continue;
      if (gave_up()) return;
      for (std::size_t i = 0; i < pairs_.size(); ++i) go_on(i, depth, number, left - 1);
      passes_.push_back(pass);
      extend(length, rolls_left - (changes_side(pass) ? 1 : 0));
      passes_.pop_back();
    }
  }
}

// The passes after which every pair could still come home in time, as a bit mask.
std::uint32_t PassSequences::allowed_passes(std::size_t depth, int left) {
  std::uint32_t allowed = ~std::uint32_t{0};
  if (depth > 0) allowed &= ~(std::uint32_t{1} << PairWays::number(passes_.back()));
  for (std::size_t i = 0; i < pairs_.size() && allowed != 0; ++i) {
    std::uint32_t own = 0;
    for (const int state : states_[depth][i]) own |= pairs_[i]->passes_allowed(state, left - 1);
    looked_at_ += static_cast<int>(states_[depth][i].size());
    allowed &= own;
  }
  return allowed;
}

void PassSequences::go_on(std::size_t pair, std::size_t depth, int pass, int left) {
  const PairWays& ways = *pairs_[pair];
  States& after = states_[depth + 1][pair];
  after.clear();
  std::vector<int>& seen = seen_[pair];
  ++round_;
  for (const int state : states_[depth][pair]) {
    const auto [begin, end] = ways.range(state, pass);
    for (int i = begin; i < end; ++i) {
      const int next = ways.next()[i];
      if (seen[next] == round_ || ways.passes_home(next) > left) continue;
      seen[next] = round_;
      after.push_back(next);
    }
  }
}

namespace {

// Rising and falling runs of even rackings; runs of one appear once.
std::vector<std::vector<int>> racking_runs(int max_racking) {
  std::vector<std::vector<int>> runs;
  const int most = max_racking - max_racking % 2;
  for (int low = -most; low <= most; low += 2) {
    for (int high = low; high <= most; high += 2) {
      std::vector<int> run;
      for (int racking = low; racking <= high; racking += 2) run.push_back(racking);
      runs.push_back(run);
      if (run.size() > 1) runs.emplace_back(run.rbegin(), run.rend());
    }
  }
  return runs;
}

class Legs {
 public:
  Legs(const Tube& tube, int length)
      : runs_(racking_runs(tube.max_racking)), length_(length), max_racking_(tube.max_racking) {
    const std::vector<Reach> reaches = distinct_reaches(tube);
    for (const Bed from : {Bed::front, Bed::back}) add_leg(from, most_legs, reaches);
    sort_by_travel(found);
  }
  std::vector<Passes> found;

 private:
  static constexpr int most_legs = 3;

  void add_leg(Bed from, int legs_left, const std::vector<Reach>& reaches) {
    for (const std::vector<int>& run : runs_) {
      const int left = length_ - static_cast<int>(passes_.size() + run.size());
      if (left < 0 || (left > 0 && legs_left == 1)) continue;
      std::vector<Reach> after = reaches;
      for (const int racking : run) {
        passes_.push_back({from, racking});
        for (Reach& reach : after) reach.pass(passes_.back());
      }
      const bool possible = std::all_of(after.begin(), after.end(), [&](const Reach& reach) {
        return reach.may_come_home(left, max_racking_);
      });
      if (possible && left == 0) found.push_back(passes_);
      if (possible && left > 0) add_leg(opposite(from), legs_left - 1, after);
      passes_.resize(passes_.size() - run.size());
    }
  }

  std::vector<std::vector<int>> runs_;
  int length_, max_racking_;
  Passes passes_;
};

}  // namespace

std::vector<Passes> sequences_in_legs(const Tube& tube, int length) {
  return Legs(tube, length).found;
}

}  // namespace meshknit
