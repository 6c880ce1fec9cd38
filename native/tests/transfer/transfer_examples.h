#pragma once

#include <cstdint>
#include <vector>

#include "meshknit/transfer/transfer_problem.h"

namespace meshknit {

/// A small generator of our own (a 64-bit linear congruence), so that every run sees the same
/// problems.
class Lcg {
 public:
  explicit Lcg(std::uint64_t seed) : state_(seed) {}
  /// A number in [0, bound).
  int below(int bound) {
    state_ = state_ * 6364136223846793005u + 1442695040888963407u;
    return static_cast<int>((state_ >> 33) % static_cast<std::uint64_t>(bound));
  }

 private:
  std::uint64_t state_;
};

/// A tube before or after transfers, one entry a loop in anticlockwise order.
struct Hanging {
  Bed bed = Bed::front;
  int place = 0;
};

/// Problem with usual slack and `room` free places on both sides.
TransferProblem moving(const std::vector<Hanging>& before, const std::vector<Hanging>& after,
                       int room = 4);

/// Front places first..last rightward, then back places first..last leftward.
std::vector<Hanging> tube_of(int front_first, int front_last, int back_first, int back_last);

/// Offsets on the front (left to right) and on the back (left to right) of an aligned tube on
/// places 0.. .
TransferProblem offsets(const std::vector<int>& front, const std::vector<int>& back,
                        int room = 4);

/// Decreases spread evenly over both beds of an aligned tube with `width` loops a bed,
/// re-centred.
TransferProblem spread_decreases(int width, int decreases_a_bed);
/// Gaps for increases, likewise.
TransferProblem spread_gaps(int width, int gaps_a_bed);
/// The aligned tube turned anticlockwise by `loops` loops and shifted.
TransferProblem rolled(int width, int loops, int shift);

/// What a schedule may ask for: offsets, decreases, gaps and up to `most_rolls` loops that
/// change beds at each end. Layouts differ by at most `most_offset` places a loop.
TransferProblem random_problem(Lcg& lcg, int most_loops_a_bed, int most_offset, int most_rolls);

}  // namespace meshknit
