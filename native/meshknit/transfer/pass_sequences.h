#pragma once

#include <cstdint>
#include <vector>

#include "meshknit/transfer/pair_ways.h"
#include "meshknit/transfer/pass.h"
#include "meshknit/transfer/tube.h"

namespace meshknit {

/// Sequences of passes in which every two neighbours of the tube could come home if they were
/// alone.
class PassSequences {
 public:
  /// Requires: `cache` outlives it.
  PassSequences(const Tube& tube, PairWaysCache& cache);

  /// No sequence is shorter than this; PairWays::far or nearly so if none is known.
  int least_length() const;

  /// All sequences of this many passes, in the order of their racking travel; some of them if
  /// there are too many to look at (`gave_up`).
  std::vector<Passes> of_length(int length);
  bool gave_up() const { return looked_at_ > most_looked_at; }

 private:
  static constexpr int most_looked_at = 50000;  // states: bounds the time of one length

  void extend(int length, int rolls_left);
  std::uint32_t allowed_passes(std::size_t depth, int left);
  void go_on(std::size_t pair, std::size_t depth, int pass, int left);

  std::vector<const PairWays*> pairs_;
  int max_racking_;
  int rolls_ = 0;
  int looked_at_ = 0;
  Passes passes_;
  std::vector<std::vector<std::vector<int>>> states_;  // [passes so far][pair]
  std::vector<std::vector<int>> seen_;  // of each pair: the round a state was found in
  int round_ = 0;
  std::vector<Passes> found_;
};

/// Sequences in which every stack of the tube could come home if it were alone, of one to three
/// legs: runs of passes in one direction whose even rackings rise or fall by steps of 2, each leg
/// against the direction of the one before.
std::vector<Passes> sequences_in_legs(const Tube& tube, int length);

}  // namespace meshknit
