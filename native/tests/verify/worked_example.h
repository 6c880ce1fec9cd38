#pragma once

#include <string>
#include <vector>

#include "meshknit/tracing/stitch.h"

namespace meshknit {

/// How both examples begin: eight loops cast on over waste, and a round and three quarters.
extern const std::string first_rounds;

/// The traced stitches of the primer's worked example (section 6), written by hand.
StitchTrace worked_trace();

/// The traced stitches of an example of ours, written by hand from the primer's recipes: a tube of
/// eight loops that parts into two of four, which meet again.
StitchTrace branches_trace();

/// The worked example's knitout text, line by line, to be damaged. A line is named by a piece
/// of text; the first line that contains it is meant.
class KnitoutLines {
 public:
  KnitoutLines();
  explicit KnitoutLines(std::string text);
  /// The text that goes with branches_trace.
  static KnitoutLines branches();

  std::string text() const;
  int find(const std::string& part) const;

  KnitoutLines& remove(const std::string& part);
  KnitoutLines& replace(const std::string& part, const std::string& with);
  KnitoutLines& replace_all(const std::string& part, const std::string& with);
  KnitoutLines& before(const std::string& part, std::vector<std::string> added);
  KnitoutLines& swap(const std::string& part, const std::string& other);

  std::vector<std::string>& lines() { return lines_; }

 private:
  std::vector<std::string> lines_;
};

}  // namespace meshknit
