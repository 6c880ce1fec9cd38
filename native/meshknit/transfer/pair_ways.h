#pragma once

#include <array>
#include <cstdint>
#include <map>
#include <vector>

#include "meshknit/transfer/itinerary.h"

namespace meshknit {

/// All states that two neighbouring stacks can pass through if nobody else were on the machine,
/// and how many passes each of them is from home: a bound that most sequences of passes fail.
/// Stacks do not stray more than two places from the stretch between where they begin and where
/// they go.
class PairWays {
 public:
  /// More passes than any plan has.
  static constexpr int far = 255;

  /// Requires: |max_racking| <= most_racking.
  PairWays(const Stack& a, const Stack& b, int turn, int max_racking);

  /// Pairs with equal keys have equal ways.
  static std::vector<int> key(const Stack& a, const Stack& b, int turn, int max_racking);

  static constexpr int most_racking = 4;
  static constexpr int all_passes = 2 * (2 * most_racking + 1);
  static constexpr int most_left = most_passes;
  static int number(const Pass& pass) {
    return (pass.from == Bed::back ? 2 * most_racking + 1 : 0) + pass.racking + most_racking;
  }

  int size() const { return static_cast<int>(passes_home_.size()); }
  /// State 0 is the beginning.
  int passes_home(int state) const { return passes_home_[state]; }
  /// The passes after which at most `left` more bring the pair home, one bit for each.
  /// Requires: 0 <= left < most_left.
  std::uint32_t passes_allowed(int state, int left) const { return allowed_[state][left]; }
  /// The states after a pass: next()[begin..end).
  std::pair<int, int> range(int state, int pass) const {
    const std::size_t at = static_cast<std::size_t>(state) * all_passes + pass;
    return {begin_[at], begin_[at + 1]};
  }
  const std::vector<int>& next() const { return next_; }

 private:
  void find_states(const Stack& a, const Stack& b, int turn, int max_racking);
  void measure(const Stack& a, const Stack& b);

  struct State {
    Stop a, b;
  };
  std::vector<State> states_;
  std::vector<int> begin_, next_;
  std::vector<std::uint8_t> passes_home_;
  std::vector<std::array<std::uint32_t, most_left>> allowed_;
};

/// Ways of pairs, each kind worked out once.
class PairWaysCache {
 public:
  const PairWays& ways(const Stack& a, const Stack& b, int turn, int max_racking);

 private:
  std::map<std::vector<int>, PairWays> known_;
};

}  // namespace meshknit
