#include "meshknit/tracing/tube_events.h"

#include <algorithm>
#include <utility>

namespace meshknit {

std::vector<TubeEvent> events_in_time(const std::vector<TubeLinks>& tubes) {
  std::vector<std::pair<double, TubeEvent>> timed;
  for (int tube = 0; tube < static_cast<int>(tubes.size()); ++tube) {
    const TubeLinks& own = tubes[tube];
    if (own.below.empty()) timed.push_back({own.begin, {TubeEvent::Kind::start, tube}});
    if (own.below.size() > 1) timed.push_back({own.begin, {TubeEvent::Kind::merge, tube}});
    if (own.above.size() > 1) {
      double begin = tubes[own.above[0]].begin;
      for (const int part : own.above) begin = std::min(begin, tubes[part].begin);
      timed.push_back({begin, {TubeEvent::Kind::split, tube}});
    }
    if (own.above.empty()) timed.push_back({own.end, {TubeEvent::Kind::end, tube}});
  }
  std::stable_sort(timed.begin(), timed.end(),
                   [](const auto& a, const auto& b) { return a.first < b.first; });
  std::vector<TubeEvent> events;
  for (const auto& event : timed) events.push_back(event.second);
  return events;
}

std::vector<TubesOnBed> rows_after(const std::vector<TubeLinks>& tubes, const TubesOnBed& row,
                                   const TubeEvent& event) {
  std::vector<TubesOnBed> rows;
  const auto at = std::find(row.begin(), row.end(), event.tube) - row.begin();
  const bool hangs = at < static_cast<long>(row.size());
  const TubeLinks& own = tubes[event.tube];
  TubesOnBed after = row;
  switch (event.kind) {
    case TubeEvent::Kind::start:
      for (std::size_t place = 0; place <= row.size(); ++place) {
        after = row;
        after.insert(after.begin() + static_cast<long>(place), event.tube);
        rows.push_back(after);
      }
      break;
    case TubeEvent::Kind::end:
      if (!hangs) break;
      after.erase(after.begin() + at);
      rows.push_back(after);
      break;
    case TubeEvent::Kind::split:
      for (TubesOnBed parts : {own.above, TubesOnBed(own.above.rbegin(), own.above.rend())}) {
        if (!hangs) break;
        after = row;
        after.insert(after.erase(after.begin() + at), parts.begin(), parts.end());
        rows.push_back(after);
      }
      break;
    case TubeEvent::Kind::merge: {
      const auto first =
          std::find_first_of(after.begin(), after.end(), own.below.begin(), own.below.end());
      TubesOnBed parts = own.below;
      if (first != after.end() && *first != parts.front())
        std::reverse(parts.begin(), parts.end());
      if (after.end() - first < static_cast<long>(parts.size()) ||
          !std::equal(parts.begin(), parts.end(), first))
        break;
      *first = event.tube;
      after.erase(first + 1, first + static_cast<long>(parts.size()));
      rows.push_back(after);
      break;
    }
  }
  return rows;
}

}  // namespace meshknit
