#include "meshknit/transfer/pass_sequences.h"

#include <algorithm>
#include <map>

#include "meshknit/transfer/itinerary.h"
#include "meshknit/transfer/reach.h"

namespace meshknit {
namespace {

// Bounds the time of one plan (some 20 ms); longer plans are found in legs or step by step.
constexpr int most_looked_at = 15000;

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

class Enumeration {
 public:
  Enumeration(const Tube& tube, int length)
      : length_(length), max_racking_(std::min(tube.max_racking, 15)) {
    int rolls = 0;
    for (const Stack& stack : tube.stacks) rolls += stack.roll() != 0;
    reaches_.resize(length + 1, distinct_reaches(tube));
    extend(rolls);
    if (!result.gave_up) sort_by_travel(result.sequences);
  }
  PassSequences result;

 private:
  void extend(int rolls_left) {
    const std::size_t depth = passes_.size();
    const int left = length_ - static_cast<int>(depth);
    std::uint64_t allowed = ~std::uint64_t{0};
    if (left == 1)
      for (const Reach& reach : reaches_[depth]) allowed &= reach.last_passes(max_racking_);
    if (!passes_.empty()) allowed &= ~pass_bit(passes_.back());
    if (allowed == 0) return;

    for (const Bed from : {Bed::front, Bed::back}) {
      for (int racking = -max_racking_; racking <= max_racking_; ++racking) {
        const Pass pass{from, racking};
        if ((allowed & pass_bit(pass)) == 0 || (changes_side(pass) && rolls_left == 0))
          continue;
        passes_.push_back(pass);
        if (left == 1)
          result.sequences.push_back(passes_);
        else if (possible_after(pass, depth, left - 1))
          extend(rolls_left - (changes_side(pass) ? 1 : 0));
        passes_.pop_back();
        if (result.gave_up) return;
      }
    }
  }

  // Fills the reaches of the next depth as far as they may still come home.
  bool possible_after(const Pass& pass, std::size_t depth, int passes_left) {
    if (++looked_at_ > most_looked_at) {
      result.gave_up = true;
      result.sequences.clear();
      return false;
    }
    for (std::size_t i = 0; i < reaches_[depth].size(); ++i) {
      Reach& after = reaches_[depth + 1][i];
      after = reaches_[depth][i];
      after.pass(pass);
      if (!after.may_come_home(passes_left, max_racking_)) return false;
    }
    return true;
  }

  int length_, max_racking_;
  int looked_at_ = 0;
  std::vector<std::vector<Reach>> reaches_;  // by depth
  Passes passes_;
};

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

PassSequences sequences_of_length(const Tube& tube, int length) {
  return Enumeration(tube, length).result;
}

std::vector<Passes> sequences_in_legs(const Tube& tube, int length) {
  return Legs(tube, length).found;
}

}  // namespace meshknit
