#pragma once

#include <map>
#include <string>
#include <vector>

#include "meshknit/core/problem.h"

namespace meshknit {

/// Collects the problems of one check. Counts all of them, keeps the first `kKept` of each
/// code: one forgotten stitch can shift a hundred thousand others.
class ProblemLog {
 public:
  static constexpr int kKept = 20;

  /// `text` is a sentence that goes on after "Line N: " (alone if line is 0), without its full
  /// stop.
  void error(const std::string& code, int line, const std::string& text,
             const std::vector<int>& stitches = {}, const std::string& remedy = "");
  void warning(const std::string& code, int line, const std::string& text,
               const std::vector<int>& stitches = {}, const std::string& remedy = "");

  /// Problems that somebody else found.
  void take(const Problems& problems);

  int errors() const { return errors_; }
  int warnings() const { return warnings_; }

  /// The problems kept, in the order in which they came, and a note for each code with more.
  Problems problems() const;

 private:
  void add(Problem problem);

  Problems kept_;
  std::map<std::string, int> count_;
  int errors_ = 0, warnings_ = 0;
};

}  // namespace meshknit
