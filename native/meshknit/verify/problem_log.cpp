#include "meshknit/verify/problem_log.h"

#include <utility>

namespace meshknit {
namespace {

// Nothing in the model causes most of these: the program itself is wrong.
constexpr const char* kReport =
    "Do not knit this file; if meshknit wrote it, please report it.";

Problem make(Severity severity, const std::string& code, int line, const std::string& text,
             const std::vector<int>& stitches, const std::string& remedy) {
  Problem problem;
  problem.code = code;
  problem.severity = severity;
  problem.message = (line > 0 ? "Line " + std::to_string(line) + ": " : "") + text + ".";
  problem.remedy = remedy.empty() ? kReport : remedy;
  if (line > 0) problem.elements.lines = {line};
  for (const int stitch : stitches) {
    if (stitch >= 0) problem.elements.stitches.push_back(stitch);
  }
  return problem;
}

}  // namespace

void ProblemLog::error(const std::string& code, int line, const std::string& text,
                       const std::vector<int>& stitches, const std::string& remedy) {
  add(make(Severity::error, code, line, text, stitches, remedy));
}

void ProblemLog::warning(const std::string& code, int line, const std::string& text,
                         const std::vector<int>& stitches, const std::string& remedy) {
  add(make(Severity::warning, code, line, text, stitches, remedy));
}

void ProblemLog::take(const Problems& problems) {
  for (const Problem& problem : problems) add(problem);
}

Problems ProblemLog::problems() const {
  Problems all = kept_;
  for (const auto& [code, count] : count_) {
    if (count <= kKept) continue;
    Problem more;
    more.code = "more-problems";
    more.severity = Severity::note;
    more.message = std::to_string(count - kKept) + " more problems of the kind " + code +
                   " are not listed.";
    more.remedy = "Look at the first of them; the others usually follow from it.";
    all.push_back(std::move(more));
  }
  return all;
}

void ProblemLog::add(Problem problem) {
  if (problem.severity == Severity::error) ++errors_;
  if (problem.severity == Severity::warning) ++warnings_;
  if (++count_[problem.code] <= kKept) kept_.push_back(std::move(problem));
}

}  // namespace meshknit
