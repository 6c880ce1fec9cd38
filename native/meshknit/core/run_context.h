#pragma once

#include <atomic>

namespace meshknit {

/// Progress and cancellation of one run. Any thread may read and cancel; one thread works.
/// Cancelling is sticky; progress never goes back.
class RunContext {
 public:
  void cancel() { cancelled_.store(true); }
  bool cancelled() const { return cancelled_.load(); }

  /// Fraction of the whole run that is done, in [0, 1].
  double progress() const { return progress_.load(); }

  /// The worker's side. A stage gets a share [begin, end] of the bar and reports its own
  /// fraction.
  void begin_stage(double begin, double end);
  /// Sets the current stage's fraction in [0, 1]. Throws Cancelled if the run was cancelled.
  void report(double fraction);

 private:
  std::atomic<bool> cancelled_{false};
  std::atomic<double> progress_{0.0};
  double stage_begin_ = 0.0;
  double stage_end_ = 1.0;
};

/// Reports to `run` if there is one.
inline void report(RunContext* run, double fraction) {
  if (run) run->report(fraction);
}

}  // namespace meshknit
