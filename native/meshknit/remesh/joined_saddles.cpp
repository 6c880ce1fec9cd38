#include "meshknit/remesh/joined_saddles.h"

#include <algorithm>
#include <limits>

#include "meshknit/surface/fast_marching.h"

namespace meshknit {
namespace {

constexpr double infinity = std::numeric_limits<double>::infinity();

// Rows keep half a row clear of the first saddle; the next row then has half a row for the others.
constexpr double room_in_rows = 0.5;

class Joining {
 public:
  Joining(const PeelState& state, double row_height, const std::vector<int>& apart,
          SweepPlan& plan)
      : state_(state),
        room_(room_in_rows * row_height),
        apart_(apart),
        plan_(plan),
        into_(plan.reeb.events.size(), -1),
        gone_(plan.reeb.arcs.size(), -1) {}

  void run() {
    const int events = static_cast<int>(plan_.reeb.events.size());
    bool any = false;
    for (int e = 0; e < events; ++e) any = join(e, Way::up) || any;
    for (int e = events; e-- > 0;) any = join(e, Way::down) || any;
    if (any) renumber();
  }

 private:
  // Splits are joined to the first one, merges to the last one.
  enum class Way { up, down };

  bool is_saddle(int e, Way way) const {
    const ReebEvent& event = plan_.reeb.events[e];
    if (into_[e] >= 0 || event.has_boundary) return false;
    const std::size_t near = (way == Way::up ? event.below : event.above).size();
    const std::size_t far = (way == Way::up ? event.above : event.below).size();
    const bool kept = std::any_of(event.vertices.begin(), event.vertices.end(), [&](int v) {
      return std::find(apart_.begin(), apart_.end(), v) != apart_.end();
    });
    return near == 1 && far > 1 && event.index == 1 - static_cast<int>(far) && !kept;
  }

  bool join(int e, Way way) {
    if (!is_saddle(e, way)) return false;
    ReebEvent& event = plan_.reeb.events[e];
    std::vector<int>& far = way == Way::up ? event.above : event.below;
    std::vector<double> distance;
    bool any = false;
    for (std::size_t k = 0; k < far.size();) {
      const ReebArc arc = plan_.reeb.arcs[far[k]];
      const int f = way == Way::up ? arc.to : arc.from;
      if (!is_saddle(f, way)) {
        ++k;
        continue;
      }
      if (distance.empty()) distance = from_level_of(e, way);
      ReebEvent& other = plan_.reeb.events[f];
      const bool near = std::any_of(other.vertices.begin(), other.vertices.end(),
                                    [&](int v) { return distance[v] <= room_; });
      if (!near) {
        ++k;
        continue;
      }
      into_[f] = e;
      gone_[far[k]] = e;
      far.erase(far.begin() + static_cast<std::ptrdiff_t>(k));
      const std::vector<int>& more = way == Way::up ? other.above : other.below;
      far.insert(far.end(), more.begin(), more.end());
      event.vertices.insert(event.vertices.end(), other.vertices.begin(), other.vertices.end());
      event.index += other.index;
      any = true;
    }
    if (!any) return false;
    std::sort(far.begin(), far.end());
    std::sort(event.vertices.begin(), event.vertices.end());
    return true;
  }

  // Distance on the far side of a saddle from its level set, out to the room that there is.
  std::vector<double> from_level_of(int e, Way way) const {
    const double level = plan_.reeb.events[e].time;
    const double sign = way == Way::up ? 1.0 : -1.0;
    const auto beyond = [&](int v) { return sign * (state_.time[v] - level) >= 0.0; };
    const int near_arc = (way == Way::up ? plan_.reeb.events[e].below.front()
                                         : plan_.reeb.events[e].above.front());
    std::vector<MarchSeed> seeds;
    for (const auto f : state_.mesh.faces()) {
      int c[3], k = 0;
      for (const auto v : state_.mesh.fv_range(f)) c[k++] = v.idx();
      if (std::none_of(c, c + 3,
                       [&](int v) { return plan_.region[v] == near_arc && !beyond(v); }))
        continue;
      std::vector<Eigen::Vector3d> curve;
      for (const int u : c)
        for (const int w : c)
          if (!beyond(u) && beyond(w)) {
            const double t = (level - state_.time[u]) / (state_.time[w] - state_.time[u]);
            curve.push_back(state_.point(u) + t * (state_.point(w) - state_.point(u)));
          }
      if (curve.empty()) continue;
      for (const int v : c)
        if (beyond(v))
          seeds.push_back(
              {v, distance_to_segment(state_.point(v), curve.front(), curve.back())});
    }
    std::vector<double> distance(plan_.region.size(), infinity);
    march(state_.mesh, state_.edge_length, seeds, 2.0 * room_, beyond, distance);
    return distance;
  }

  void renumber() {
    ReebGraph& reeb = plan_.reeb;
    const int old_arcs = static_cast<int>(reeb.arcs.size());
    std::vector<int> new_event(reeb.events.size(), -1), new_arc(reeb.arcs.size(), -1);
    std::vector<ReebEvent> events;
    std::vector<ReebArc> arcs;
    std::vector<double> end_level;
    plan_.joined.clear();
    std::vector<char> has_joined(reeb.events.size(), 0);
    for (const int e : into_)
      if (e >= 0) has_joined[e] = 1;
    for (std::size_t e = 0; e < reeb.events.size(); ++e) {
      if (into_[e] >= 0) continue;
      new_event[e] = static_cast<int>(events.size());
      events.push_back(std::move(reeb.events[e]));
      plan_.joined.push_back(has_joined[e]);
    }
    for (std::size_t e = 0; e < into_.size(); ++e)
      if (into_[e] >= 0) new_event[e] = new_event[into_[e]];
    for (int a = 0; a < old_arcs; ++a) {
      if (gone_[a] >= 0) continue;
      new_arc[a] = static_cast<int>(arcs.size());
      arcs.push_back({new_event[reeb.arcs[a].from], new_event[reeb.arcs[a].to]});
      end_level.push_back(plan_.end_level[a]);
    }
    for (ReebEvent& event : events)
      for (std::vector<int>* list : {&event.below, &event.above})
        for (int& arc : *list) arc = new_arc[arc];
    for (int& region : plan_.region) {
      const int event = region >= old_arcs   ? new_event[region - old_arcs]
                        : gone_[region] >= 0 ? new_event[gone_[region]]
                                             : -1;
      region = event >= 0 ? static_cast<int>(arcs.size()) + event : new_arc[region];
    }
    for (int& arc : reeb.arc_of_vertex)
      if (arc >= 0) arc = new_arc[arc];
    reeb.events = std::move(events);
    reeb.arcs = std::move(arcs);
    plan_.end_level = std::move(end_level);
  }

  const PeelState& state_;
  double room_;
  const std::vector<int>& apart_;
  SweepPlan& plan_;
  std::vector<int> into_;  // per event: the one that it is joined to, -1 for none
  std::vector<int> gone_;  // per arc: the event that it has become part of, -1 for none
};

}  // namespace

void join_near_saddles(const PeelState& state, double row_height, const std::vector<int>& apart,
                       SweepPlan& plan) {
  Joining(state, row_height, apart, plan).run();
}

}  // namespace meshknit
