#pragma once

#include <functional>
#include <vector>

#include "meshknit/tracing/stitch.h"
#include "verify/worked_example.h"

namespace meshknit {

/// A copy of a good file that breaks one rule.
struct BrokenCopy {
  const char* what;
  const char* code;  ///< of the rule that it breaks
  std::function<void(KnitoutLines&)> damage;
  bool alone = false;  ///< no other rule is broken
};

/// Copies of the worked example: the primer's list, and what it leaves out; copies of the example
/// that parts and meets again.
const std::vector<BrokenCopy>& copies_of_primers_list();
const std::vector<BrokenCopy>& further_copies();
const std::vector<BrokenCopy>& copies_of_branches();

/// Expects that the Shima's check refuses every copy and names its rule as an error.
void expect_refused(const std::vector<BrokenCopy>& copies, const KnitoutLines& good,
                    const StitchTrace& trace);

}  // namespace meshknit
