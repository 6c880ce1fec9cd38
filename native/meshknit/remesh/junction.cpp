#include "meshknit/remesh/junction.h"

#include <algorithm>
#include <cmath>
#include <limits>

#include "meshknit/core/error.h"
#include "meshknit/remesh/junction_links.h"
#include "meshknit/remesh/sampling.h"
#include "meshknit/surface/wording.h"

namespace meshknit {
namespace {

constexpr double turn = 6.28318530717958647692;

// Where rows of the full height do not part or meet as they should, lower ones do.
constexpr double heights[] = {1.0, 0.75, 0.55, 0.4, 0.25, 0.1, 0.0};

class Junction {
 public:
  Junction(Peel& peel, int event, const std::vector<ActiveCycle>& below)
      : peel_(peel),
        number_(event),
        event_(peel.plan.reeb.events[event]),
        saddle_(peel.plan.vertices_of_region[peel.plan.event_region(event)]),
        below_(below) {
    for (const ActiveCycle& active : below_) cycles_.push_back(&active.cycle);
  }

  std::vector<ActiveCycle> knit() {
    require_simple();
    find_rows();
    knit_surface();
    if (below_.size() == 1) return split();
    return {merge()};
  }

 private:
  [[noreturn]] void refuse(const std::string& why) const {
    const int vertex = event_.vertices.front();
    Problem problem;
    problem.code = "junction-too-tight";
    problem.message = "Near " + place_text(peel_.state.point(vertex)) + ", where tubes " +
                      (below_.size() == 1 ? "part" : "meet") + ", " + why;
    problem.remedy =
        "Take finer stitches or a larger object, make these parts thicker, or move the times "
        "so "
        "that the tubes part and meet further from each other.";
    problem.elements.faces = peel_.faces_near(vertex);
    throw NotKnittable({problem});
  }

  void require_simple() const {
    if (below_.size() * event_.above.size() == 2 && event_.index == -1) return;
    refuse(
        "more than three tubes come together in one spot, or a handle begins and ends in it.");
  }

  void open_tubes() {
    peel_.limits.close_all();
    peel_.limits.finish(peel_.plan.event_region(number_));
    for (const int arc : event_.below) peel_.limits.finish(arc);
    for (const int arc : event_.above) peel_.limits.open(arc);
  }

  void find_rows() {
    open_tubes();
    for (const double part : heights)
      if (slice(part * peel_.row_height)) return;
    refuse("they are too thin or too near to each other for this gauge.");
  }

  // The rows above at this height, one a tube; false if there are others.
  bool slice(double level) {
    level_ = level;
    double limit = 1.2 * peel_.row_height;
    const auto reached = [&](int v) {
      return peel_.state.knitted[v] || std::isfinite(peel_.band.distance(v));
    };
    do {
      peel_.band.measure(cycles_, limit);
      limit *= 2.0;
    } while (!std::all_of(saddle_.begin(), saddle_.end(), reached) && limit < 1e6);
    std::vector<NextCycle> found =
        peel_.slicer.slice(peel_.band, cycles_, RowLevel::of_height(level));
    next_.assign(event_.above.size(), NextCycle{});
    pockets_.clear();
    std::vector<NextCycle> nameless;
    for (NextCycle& cycle : found) {
      const int tube = tube_of(cycle);
      if (tube == pocket) {
        pockets_.push_back(std::move(cycle));
      } else if (tube < 0) {
        nameless.push_back(std::move(cycle));
      } else if (next_[tube].cycle.size() > 0) {
        return false;
      } else {
        next_[tube] = std::move(cycle);
      }
    }
    if (nameless.size() > 1) return false;
    for (NextCycle& next : next_) {
      if (next.cycle.size() > 0) continue;
      if (nameless.empty()) return false;
      next = std::move(nameless.back());
      nameless.pop_back();
    }
    return nameless.empty();
  }

  // Which tube a cycle leads to, by the vertices just beyond it.
  int tube_of(const NextCycle& next) {
    std::vector<int> votes(event_.above.size(), 0);
    for (const EdgeCrossing& c : next.cycle.crossings)
      for (std::size_t k = 0; k < votes.size(); ++k)
        votes[k] += peel_.plan.region[peel_.state.to(c.halfedge)] == event_.above[k];
    const auto most = std::max_element(votes.begin(), votes.end());
    if (is_pocket(next)) return pocket;
    if (*most == 0) return -1;
    return static_cast<int>(most - votes.begin());
  }

  // A few vertices beyond the row that the rows go round: they are knitted over.
  bool is_pocket(const NextCycle& next) const {
    constexpr std::size_t largest = 60;
    std::vector<int> inside{peel_.state.to(next.cycle.crossings.front().halfedge)};
    for (std::size_t k = 0; k < inside.size(); ++k) {
      if (inside.size() > largest || !peel_.limits.may_knit(inside[k])) return false;
      for (const auto w : peel_.state.mesh.vv_range(TriangleMesh::VertexHandle(inside[k]))) {
        const int v = w.idx();
        if (!below_level(v) && std::find(inside.begin(), inside.end(), v) == inside.end())
          inside.push_back(v);
      }
    }
    return true;
  }
  bool below_level(int v) const {
    return peel_.state.knitted[v] || peel_.limits.must_knit(v) ||
           (peel_.band.distance(v) < level_ && peel_.limits.may_knit(v));
  }

  void knit_surface() {
    std::vector<int> now;
    for (const int v : peel_.band.reached())
      if (below_level(v)) now.push_back(v);
    for (const int arc : event_.below)
      for (const int v : peel_.plan.vertices_of_region[arc])
        if (!peel_.state.knitted[v]) now.push_back(v);
    for (const NextCycle& island : pockets_) {
      now.push_back(peel_.state.to(island.cycle.crossings.front().halfedge));
      for (std::size_t k = now.size() - 1; k < now.size(); ++k)
        for (const auto w : peel_.state.mesh.vv_range(TriangleMesh::VertexHandle(now[k])))
          if (!below_level(w.idx()) && std::find(now.begin(), now.end(), w.idx()) == now.end())
            now.push_back(w.idx());
    }
    for (const int v : now) {
      peel_.knitted += !peel_.state.knitted[v];
      peel_.state.knitted[v] = 1;
    }
    for (const NextCycle& next : next_)
      for (const EdgeCrossing& c : next.cycle.crossings)
        peel_.state.crossing[c.halfedge >> 1] = c.t;
  }

  // Adds a closed row of nodes at these places.
  ActiveCycle add_row(const NextCycle& next, const std::vector<double>& places) {
    NextRow row;
    row.place = places;
    for (const double place : places)
      row.time.push_back(next.cycle.value(next.cycle.at(place), next.time));
    const std::vector<int> node_of = peel_.builder.add_rows(next, row);
    ActiveCycle active;
    active.cycle = next.cycle;
    for (std::size_t j = 0; j < places.size(); ++j)
      active.nodes.push_back(active_node(next, places[j], node_of[j]));
    place_nodes(active, peel_.piece_of_edge);
    return active;
  }

  std::vector<ActiveCycle> split() {
    const ActiveCycle& active = below_.front();
    const int n = static_cast<int>(active.nodes.size());
    if (n < 2 * fewest_round) refuse("the tube below has too few stitches to part.");
    const std::vector<NodeImage> images[2] = {images_on_next(active, 0, next_[0]),
                                              images_on_next(active, 0, next_[1])};
    std::vector<double> weights;
    for (int i = 0; i < n; ++i)
      weights.push_back(images[0][i].off < images[1][i].off ? 1.0 : -1.0);
    const Stretch first = best_stretch(weights, fewest_round);
    const Stretch parts[2] = {first, {(first.first + first.count) % n, n - first.count}};
    std::vector<ActiveCycle> above;
    for (int k = 0; k < 2; ++k) {
      const Stretch& part = parts[k];
      const double spacing = next_[k].cycle.length() / part.count;
      double x = 0.0, y = 0.0;  // the mean of where the nodes want the first place to be
      for (int i = 0; i < part.count; ++i) {
        const double angle =
            turn * (images[k][(part.first + i) % n].place / spacing - i) / part.count;
        x += std::cos(angle);
        y += std::sin(angle);
      }
      const double begin = std::atan2(y, x) / turn * next_[k].cycle.length();
      std::vector<double> places;
      for (int i = 0; i < part.count; ++i)
        places.push_back(forward(0.0, begin + i * spacing, next_[k].cycle.length()));
      above.push_back(add_row(next_[k], places));
      for (int i = 0; i < part.count; ++i)
        peel_.builder.add_column(active.nodes[(part.first + i) % n].node,
                                 above.back().nodes[i].node);
    }
    return above;
  }

  ActiveCycle merge() {
    const NextCycle& next = next_.front();
    const int m = next.cycle.size();
    std::vector<double> weights;
    for (int i = 0; i < m; ++i) {
      const double share = next.cycle.arc[i + 1] - next.cycle.arc[i];
      weights.push_back(next.source[i] == 0 ? share : -share);
    }
    if (m < 2) refuse("they are too small for this gauge.");
    const Stretch first = best_stretch(weights, 1);
    const double length = next.cycle.length();
    const double begin = next.cycle.arc[first.first];
    const double end = next.cycle.arc[(first.first + first.count) % m];
    std::vector<double> places;
    std::vector<int> lower;
    for (int k = 0; k < 2; ++k) {
      const ActiveCycle& active = below_[k];
      const int n = static_cast<int>(active.nodes.size());
      const double from = k == 0 ? begin : end,
                   span = forward(from, k == 0 ? end : begin, length);
      std::vector<double> here;
      for (int i = 0; i < n; ++i) here.push_back(from + (i + 0.5) * span / n);
      const int shift = best_shift(images_on_next(active, k, next), here, length);
      for (int i = 0; i < n; ++i) {
        places.push_back(forward(0.0, here[i], length));
        lower.push_back(active.nodes[(i + shift) % n].node);
      }
    }
    ActiveCycle above = add_row(next, places);
    for (std::size_t i = 0; i < lower.size(); ++i)
      peel_.builder.add_column(lower[i], above.nodes[i].node);
    return above;
  }

  // Which node goes to the first place, so that all are as near to their images as can be.
  static int best_shift(const std::vector<NodeImage>& images, const std::vector<double>& places,
                        double length) {
    const int n = static_cast<int>(images.size());
    int best = 0;
    double least = std::numeric_limits<double>::infinity();
    for (int shift = 0; shift < n; ++shift) {
      double sum = 0.0;
      for (int i = 0; i < n && sum < least; ++i) {
        const double off = around(images[(i + shift) % n].place, places[i], length);
        sum += off * off;
      }
      if (sum < least) {
        least = sum;
        best = shift;
      }
    }
    return best;
  }

  static constexpr int pocket = -2;

  Peel& peel_;
  int number_;
  const ReebEvent& event_;
  const std::vector<int>& saddle_;  // the vertices near the saddle, which this step knits
  const std::vector<ActiveCycle>& below_;
  std::vector<const Cycle*> cycles_;
  double level_ = 0.0;
  std::vector<NextCycle> next_, pockets_;
};

}  // namespace

std::vector<ActiveCycle> knit_junction(Peel& peel, int event,
                                       const std::vector<ActiveCycle>& below) {
  return Junction(peel, event, below).knit();
}

}  // namespace meshknit
