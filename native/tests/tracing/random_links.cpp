#include "tracing/random_links.h"

#include <set>
#include <utility>

#include "graphs.h"

namespace meshknit {
namespace {

class RandomLinks {
 public:
  RandomLinks(std::uint64_t seed, int most) : dice_(seed), most_(most) {}

  std::vector<TubeLinks> draw() {
    add({});
    while (static_cast<int>(tubes_.size()) + 3 <= most_) {
      const int kind = dice_.roll(8);
      if (kind == 0) add({});
      if (kind > 0 && kind < 4) {
        const int whole = take();
        const int parts = dice_.roll(5) == 0 ? 3 : 2;
        for (int part = 0; part < parts; ++part) add({whole});
      }
      if (kind >= 4 && live_.size() > 1) {
        std::vector<int> parts{take(), take()};
        if (!live_.empty() && dice_.roll(5) == 0) parts.push_back(take());
        add(parts);
      }
      if (live_.empty()) add({});
    }
    return tubes_;
  }

 private:
  int take() {
    const int at = dice_.roll(static_cast<int>(live_.size()));
    const int tube = live_[at];
    live_.erase(live_.begin() + at);
    return tube;
  }

  void add(const std::vector<int>& below) {
    const int tube = static_cast<int>(tubes_.size());
    const double time = tube;
    for (const int part : below) {
      tubes_[part].above.push_back(tube);
      tubes_[part].end = time;
    }
    tubes_.push_back({below, {}, time, time + 100.0});
    live_.push_back(tube);
  }

  Dice dice_;
  int most_;
  std::vector<TubeLinks> tubes_;
  std::vector<int> live_;  // that end or go on
};

class AllOrders {
 public:
  explicit AllOrders(const std::vector<TubeLinks>& tubes)
      : tubes_(tubes), events_(events_in_time(tubes)) {}

  bool hang() { return follow(std::vector<bool>(events_.size(), false), {}); }

 private:
  bool follow(const std::vector<bool>& done, const TubesOnBed& row) {
    if (!seen_.insert({done, row}).second) return false;
    bool all = true;
    for (std::size_t e = 0; e < events_.size(); ++e) {
      if (done[e]) continue;
      all = false;
      std::vector<bool> after = done;
      after[e] = true;
      for (const TubesOnBed& next : rows_after(tubes_, row, events_[e]))
        if (follow(after, next)) return true;
    }
    return all;
  }

  const std::vector<TubeLinks>& tubes_;
  std::vector<TubeEvent> events_;
  std::set<std::pair<std::vector<bool>, TubesOnBed>> seen_;
};

}  // namespace

std::vector<TubeLinks> random_links(std::uint64_t seed, int most) {
  return RandomLinks(seed, most).draw();
}

bool hang_in_some_order(const std::vector<TubeLinks>& tubes) { return AllOrders(tubes).hang(); }

}  // namespace meshknit
