#pragma once

#include <atomic>
#include <mutex>
#include <optional>
#include <utility>

#include "meshknit/knit_graph/knit_graph.h"

namespace meshknit {

/// The rows that are knit so far, for one who looks on while a graph is made. One thread looks, another
/// one works; rows are copied only when they are asked for.
class FirstRows {
 public:
  /// The looker's side: asks for the rows as they will be next, and takes what came since, if anything.
  /// Such a graph has its rows and columns in order, but no lengths, and its nodes are not relaxed.
  std::optional<KnitGraph> take() {
    const std::lock_guard<std::mutex> lock(mutex_);
    wanted_ = true;
    return std::exchange(rows_, std::nullopt);
  }

  /// The worker's side.
  bool wanted() const { return wanted_; }
  void offer(const KnitGraph& rows) {
    const std::lock_guard<std::mutex> lock(mutex_);
    rows_ = rows;
    wanted_ = false;
  }

 private:
  std::mutex mutex_;
  std::optional<KnitGraph> rows_;
  std::atomic<bool> wanted_{false};
};

}  // namespace meshknit
