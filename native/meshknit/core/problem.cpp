#include "meshknit/core/problem.h"

#include <algorithm>

namespace meshknit {

bool has_errors(const Problems& problems) {
  return std::any_of(problems.begin(), problems.end(),
                     [](const Problem& p) { return p.severity == Severity::error; });
}

const Problem* find_problem(const Problems& problems, const std::string& code) {
  const auto found = std::find_if(problems.begin(), problems.end(),
                                  [&](const Problem& p) { return p.code == code; });
  return found == problems.end() ? nullptr : &*found;
}

}  // namespace meshknit
