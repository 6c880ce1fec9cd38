#pragma once

#include <vector>

#include "meshknit/verify/expected_loops.h"
#include "meshknit/verify/fabric.h"
#include "meshknit/verify/trace_columns.h"
#include "meshknit/verify/tubes.h"

namespace meshknit {

/// Which tube a loop on an empty needle belongs to. Waste is cast on for a round of starts: its
/// loops are those that the starts are knit through, or that lie below. All else goes on with the
/// tube that its yarn comes from.
class CastOns {
 public:
  CastOns(const Fabric& fabric, const std::vector<ExpectedLoop>& items,
          const TraceColumns& traced);

  /// The tube, -1 for a new one. `column_of` gives the column of every loop made so far.
  int tube(int loop, const Tubes& tubes, const std::vector<int>& column_of) const;
  void made(int loop, int column);

 private:
  const Fabric& fabric_;
  std::vector<int> round_of_;    // loop -> round of starts, -1 for none
  std::vector<int> column_for_;  // round of starts -> a column of its tube
};

}  // namespace meshknit
