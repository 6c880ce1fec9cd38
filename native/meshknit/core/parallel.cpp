#include "meshknit/core/parallel.h"

#include <algorithm>
#include <atomic>
#include <condition_variable>
#include <exception>
#include <mutex>
#include <system_error>
#include <thread>
#include <utility>
#include <vector>

namespace meshknit {
namespace {

// Helpings come in quick succession: a thread looks so often whether there is another one before it
// lies down to sleep, from which it takes long to wake.
constexpr int looks = 300;

template <class Done>
void look_a_while(const Done& done) {
  for (int k = 0; k < looks && !done(); ++k) std::this_thread::yield();
}

// One helping of work.
class Helping {
 public:
  Helping(int count, const std::function<void(int, int)>& work) : count_(count), work_(work) {}

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

struct Team::Threads {
  std::mutex mutex;
  std::condition_variable wake, rest;
  Helping* helping = nullptr;  // the one that is open
  std::atomic<int> number{0};  // of the helpings so far
  std::atomic<int> at_work{0};
  std::atomic<bool> go_home{false};
  std::vector<std::thread> others;

  void help(int worker) {
    int seen = 0;
    for (;;) {
      look_a_while([&] { return go_home || number != seen; });
      std::unique_lock<std::mutex> lock(mutex);
      wake.wait(lock, [&] { return go_home || (helping != nullptr && number != seen); });
      if (go_home) return;
      seen = number;
      Helping& mine = *helping;
      ++at_work;
      lock.unlock();
      mine.take_part(worker);
      lock.lock();
      if (--at_work == 0) rest.notify_one();
    }
  }
};

Team::Team(int most) : threads_(std::make_unique<Threads>()) {
  const int workers = std::min(most, static_cast<int>(std::thread::hardware_concurrency()));
  std::vector<std::thread>& others = threads_->others;
  others.reserve(static_cast<std::size_t>(std::max(0, workers)));
  try {
    for (int worker = 1; worker < workers; ++worker)
      others.emplace_back(&Threads::help, threads_.get(), worker);
  } catch (const std::system_error&) {
    // The system gives no more threads: those that there are do all of the work.
  }
}

Team::~Team() {
  {
    const std::lock_guard<std::mutex> lock(threads_->mutex);
    threads_->go_home = true;
  }
  threads_->wake.notify_all();
  for (std::thread& other : threads_->others) other.join();
}

int Team::workers() const { return 1 + static_cast<int>(threads_->others.size()); }

void Team::for_each(int count, const std::function<void(int, int)>& work) {
  Threads& t = *threads_;
  Helping helping(count, work);
  const bool shared = count > 1 && !t.others.empty();
  if (shared) {
    {
      const std::lock_guard<std::mutex> lock(t.mutex);
      t.helping = &helping;
      ++t.number;
    }
    t.wake.notify_all();
  }
  helping.take_part(0);
  if (shared) {
    look_a_while([&] { return t.at_work == 0; });
    std::unique_lock<std::mutex> lock(t.mutex);
    t.helping = nullptr;
    t.rest.wait(lock, [&] { return t.at_work == 0; });
  }
  helping.rethrow();
}

}  // namespace meshknit
