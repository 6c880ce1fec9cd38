#pragma once

#include <string>
#include <vector>

namespace meshknit {

/// What a knitout program for the Shima, or for the Kniterate if its header says so, makes, found in the plainest way: for the tests that hold
/// the check to account. Shares nothing with the library, knows no trace and no tubes.
struct PlainKnitting {
  /// The first rule of the machine that is broken, empty if none is (primer, sections 2 to 4 and 7,
  /// steps 1 to 4 and the distances of step 6).
  std::string broken_rule;
  /// The object's loops, yarn by yarn: kind, way round the tube, and the loops below.
  std::vector<std::string> fabric;
};

PlainKnitting knit_plainly(const std::vector<std::string>& lines);

}  // namespace meshknit
