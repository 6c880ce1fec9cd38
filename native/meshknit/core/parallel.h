#pragma once

#include <functional>
#include <memory>

namespace meshknit {

/// Threads that share work, plain std::threads. They live as long as the team: for work that comes in
/// many small helpings they need not be made again each time.
class Team {
 public:
  /// As many workers as the machine has processors, but no more than `most`. The caller's own thread is
  /// worker 0 and, where the system gives no other, the only one.
  explicit Team(int most);
  ~Team();
  Team(const Team&) = delete;
  Team& operator=(const Team&) = delete;

  /// At least 1.
  int workers() const;

  /// Calls work(k, worker) once for every k in [0, count); calls begin in the order of k. Scratch may be
  /// kept for each worker; what is computed for k must not depend on who computes it. Nobody waits for
  /// a thread that has not begun: on a busy machine the caller does all of the work.
  /// Throws: what the work for the lowest k throws that throws at all, as a plain loop would; work
  /// that was begun before is done then, and what comes after may or may not be.
  /// Requires: not called from within work, and by one thread at a time.
  void for_each(int count, const std::function<void(int k, int worker)>& work);

 private:
  struct Threads;
  std::unique_ptr<Threads> threads_;
};

}  // namespace meshknit
