#pragma once

#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "meshknit/machine/program.h"

namespace meshknit {

/// What is wrong with one operation line; `warning` if the line can be used all the same.
struct OperationComplaint {
  std::string code;
  std::string message;  ///< a sentence without the line number
  bool warning = false;
};

/// One operation line, without its comment -> instruction (source and line not set). Nothing if
/// the line cannot be understood; then `complaint` says why.
///
/// Operations without a carrier become what they mean: knit -> drop, tuck -> amiss, split ->
/// xfer, without a direction. "stitch L T" and x- operations become extensions, one space
/// between words. Carriers must be among `declared` (all are accepted while `declared` is
/// null).
std::optional<Instruction> parse_operation(const std::vector<std::string_view>& words,
                                           const std::vector<std::string>* declared,
                                           std::optional<OperationComplaint>& complaint);

}  // namespace meshknit
