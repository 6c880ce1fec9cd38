#pragma once

#include <vector>

#include "meshknit/verify/fabric.h"
#include "meshknit/verify/problem_log.h"
#include "meshknit/verify/tubes.h"

namespace meshknit {

/// Watches that yarn stays out of tubes that it does not belong to (primer, section 7, step 7).
/// Yarn from a loop to the next one on its carrier runs through a tube that has loops on both sides
/// of it (verify/tubes.h): the tube would be sewn shut. A carrier that waits where another tube is
/// knit on both beds on both of its sides leaves its yarn in that tube: a warning.
class YarnPaths {
 public:
  YarnPaths(const Fabric& fabric, const Tubes& tubes, ProblemLog& log)
      : fabric_(fabric), tubes_(tubes), log_(log), last_of_(fabric.yarns.size(), -1) {}

  /// A loop was made that is no anchor; `column_of` gives the column of every loop so far, -1 for
  /// anchors.
  void made(int loop, const std::vector<int>& column_of);

 private:
  void check_way(int loop, const std::vector<int>& column_of);
  void check_waiting(int loop, const std::vector<int>& column_of);

  const Fabric& fabric_;
  const Tubes& tubes_;
  ProblemLog& log_;
  std::vector<int> last_of_;  // yarn -> its last loop
  std::vector<int> in_;       // yarns that have loops and may not have gone out
  int last_yarn_ = -1;
};

}  // namespace meshknit
