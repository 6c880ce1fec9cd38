#include "meshknit/core/parallel.h"

#include <algorithm>
#include <atomic>
#include <exception>
#include <mutex>
#include <system_error>
#include <thread>
#include <vector>

namespace meshknit {
namespace {

class Shared {
 public:
  Shared(int count, const std::function<void(int, int)>& work) : count_(count), work_(work) {}

  void take_part(int worker) {
    // What was taken is done, so that all before the first to fail is.
    while (!stopped_) {
      const int k = next_++;
      if (k >= count_) return;
      try {
        work_(k, worker);
      } catch (...) {
        stop(k, std::current_exception());
      }
    }
  }

  void rethrow() const {
    if (thrown_) std::rethrow_exception(thrown_);
  }

 private:
  void stop(int k, std::exception_ptr thrown) {
    const std::lock_guard<std::mutex> lock(mutex_);
    if (!thrown_ || k < failed_) {
      failed_ = k;
      thrown_ = std::move(thrown);
    }
    stopped_ = true;
  }

  int count_;
  const std::function<void(int, int)>& work_;
  std::atomic<int> next_{0};
  std::atomic<bool> stopped_{false};
  std::mutex mutex_;
  int failed_ = 0;
  std::exception_ptr thrown_;
};

}  // namespace

int workers_for(int count) {
  const int processors = static_cast<int>(std::thread::hardware_concurrency());
  return std::max(1, std::min(count, processors));
}

void for_each_in_parallel(int count, const std::function<void(int, int)>& work) {
  Shared shared(count, work);
  const int workers = workers_for(count);
  std::vector<std::thread> others;
  others.reserve(static_cast<std::size_t>(workers));
  try {
    for (int worker = 1; worker < workers; ++worker)
      others.emplace_back(&Shared::take_part, &shared, worker);
  } catch (const std::system_error&) {
    // The system gives no more threads: those that there are do all of the work.
  }
  shared.take_part(0);
  for (std::thread& other : others) other.join();
  shared.rethrow();
}

}  // namespace meshknit
