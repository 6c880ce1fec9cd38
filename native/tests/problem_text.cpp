#include "problem_text.h"

namespace meshknit {

std::string errors_of(const Problems& problems) {
  std::string text;
  for (const Problem& problem : problems)
    if (problem.severity == Severity::error)
      text += problem.code + ": " + problem.message + "\n";
  return text;
}

}  // namespace meshknit
