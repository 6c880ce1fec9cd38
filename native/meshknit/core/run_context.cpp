#include "meshknit/core/run_context.h"

#include <algorithm>

#include "meshknit/core/error.h"

namespace meshknit {

void RunContext::begin_stage(double begin, double end) {
  stage_begin_ = begin;
  stage_end_ = end;
  report(0.0);
}

void RunContext::report(double fraction) {
  if (cancelled()) throw Cancelled();
  const double now =
      stage_begin_ + std::clamp(fraction, 0.0, 1.0) * (stage_end_ - stage_begin_);
  if (now > progress_.load()) progress_.store(now);
}

}  // namespace meshknit
