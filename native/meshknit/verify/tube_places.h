#pragma once

#include <map>
#include <utility>
#include <vector>

#include "meshknit/verify/problem_log.h"
#include "meshknit/verify/tubes.h"

namespace meshknit {

/// Remembers which tubes stand left and right of each other. Two tubes may lie opposite each other
/// for a while, each on one bed, but must come back to the sides on which they stood: otherwise
/// their fabrics are wound round each other.
class TubePlaces {
 public:
  TubePlaces(const Tubes& tubes, ProblemLog& log) : tubes_(tubes), log_(log) {}

  /// A column of the tube came, went or moved.
  void touched(int tube);
  /// A stitch is about to be made: compares the tubes touched since the last one with all others.
  void check(int line);
  /// The tubes that a junction made of the two (or one) that there were.
  void parted(int tube, int from);
  void met(int tube, int with);

 private:
  int known(int tube, int other) const;
  void set(int tube, int other, int side);

  const Tubes& tubes_;
  ProblemLog& log_;
  std::vector<int> touched_;
  std::map<std::pair<int, int>, int> sides_;  // lower number first; 1: it stands left
};

}  // namespace meshknit
