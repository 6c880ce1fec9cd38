#pragma once

#include <stdexcept>
#include <string>
#include <utility>

#include "meshknit/core/problem.h"

namespace meshknit {

/// The caller's arguments make no sense (sizes, ranges, unknown names). A usage mistake, not a
/// model's.
class InvalidInput : public std::invalid_argument {
 public:
  using std::invalid_argument::invalid_argument;
};

/// This model cannot be knit as asked. `problems()` holds at least one error.
class NotKnittable : public std::runtime_error {
 public:
  explicit NotKnittable(Problems problems)
      : std::runtime_error(problems.empty() ? "not knittable" : problems.front().message),
        problems_(std::move(problems)) {}
  const Problems& problems() const { return problems_; }

 private:
  Problems problems_;
};

/// A promise of ours broke: a stage's result failed its own check. Please report.
class BrokenPromise : public std::logic_error {
 public:
  using std::logic_error::logic_error;
};

/// The run was cancelled; no result.
class Cancelled : public std::runtime_error {
 public:
  Cancelled() : std::runtime_error("cancelled") {}
};

}  // namespace meshknit
