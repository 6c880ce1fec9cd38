#include "meshknit/remesh/junction.h"

#include <algorithm>
#include <cmath>
#include <limits>

#include "meshknit/core/error.h"
#include "meshknit/remesh/junction_links.h"
#include "meshknit/remesh/sampling.h"
#include "meshknit/remesh/side_by_side.h"
#include "meshknit/surface/wording.h"

namespace meshknit {
namespace {

constexpr double turn = 6.28318530717958647692;

// Where rows of the full height do not part or meet as they should, lower ones do.
constexpr double heights[] = {1.0, 0.75, 0.55, 0.4, 0.25, 0.1, 0.0};

// Stitches that a middle part has at least on each bed.
constexpr int fewest_side = 2;

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
    if (peel_.plan.joined[number_]) throw NotInOneRow{event_.vertices};
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
    const int parts = static_cast<int>(std::max(below_.size(), event_.above.size()));
    const bool one = std::min(below_.size(), event_.above.size()) == 1;
    if (one && parts > 1 && event_.index == 1 - parts) return;
    refuse("tubes part and meet in one spot, or a handle begins and ends in it.");
  }

  void open_tubes() {
    peel_.limits.close_all();
    peel_.limits.finish(peel_.plan.event_region(number_));
    for (const int arc : event_.below) peel_.limits.finish(arc);
    for (const int arc : event_.above) peel_.limits.open(arc);
  }

  void find_rows() {
    open_tubes();
    for (const double part : heights) {
      if (peel_.plan.joined[number_] && part < 1.0) break;  // lower rows do not reach over all
      if (slice(part * peel_.row_height)) return;
    }
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
    const int parts = static_cast<int>(next_.size());
    if (n < parts * fewest_round) refuse("the tube below has too few stitches to part.");
    std::vector<std::vector<NodeImage>> images;
    for (const NextCycle& next : next_) images.push_back(images_on_next(active, 0, next));
    const std::vector<std::vector<int>> part = nodes_of_parts(images);
    std::vector<ActiveCycle> above;
    for (int k = 0; k < parts; ++k) {
      const int count = static_cast<int>(part[k].size());
      const double spacing = next_[k].cycle.length() / count;
      double x = 0.0, y = 0.0;  // the mean of where the nodes want the first place to be
      for (int i = 0; i < count; ++i) {
        const double angle = turn * (images[k][part[k][i]].place / spacing - i) / count;
        x += std::cos(angle);
        y += std::sin(angle);
      }
      const double begin = std::atan2(y, x) / turn * next_[k].cycle.length();
      std::vector<double> places;
      for (int i = 0; i < count; ++i)
        places.push_back(forward(0.0, begin + i * spacing, next_[k].cycle.length()));
      above.push_back(add_row(next_[k], places));
      for (int i = 0; i < count; ++i)
        peel_.builder.add_column(active.nodes[part[k][i]].node, above.back().nodes[i].node);
    }
    return above;
  }

  // Which of the lower row's nodes go to each tube above, going round that tube.
  std::vector<std::vector<int>> nodes_of_parts(
      const std::vector<std::vector<NodeImage>>& images) const {
    const int n = static_cast<int>(images.front().size());
    std::vector<PartStretch> stretches;
    if (images.size() == 2) {
      std::vector<double> weights;
      for (int i = 0; i < n; ++i)
        weights.push_back(images[0][i].off < images[1][i].off ? 1.0 : -1.0);
      const Stretch first = best_stretch(weights, fewest_round);
      stretches = {{0, first.first, first.count},
                   {1, (first.first + first.count) % n, n - first.count}};
    } else {
      stretches = balanced(images);
    }
    std::vector<std::vector<int>> nodes(images.size());
    for (const PartStretch& stretch : stretches)
      for (int i = 0; i < stretch.count; ++i)
        nodes[stretch.part].push_back((stretch.first + i) % n);
    return nodes;
  }

  std::vector<PartStretch> balanced(const std::vector<std::vector<NodeImage>>& images) const {
    const int n = static_cast<int>(images.front().size());
    const int parts = static_cast<int>(images.size());
    std::vector<int> nearest(n, 0);
    std::vector<std::vector<double>> cost(parts, std::vector<double>(n));
    for (int i = 0; i < n; ++i)
      for (int k = 0; k < parts; ++k) {
        cost[k][i] = images[k][i].off * images[k][i].off;
        if (images[k][i].off < images[nearest[i]][i].off) nearest[i] = k;
      }
    const std::vector<PartStretch> wanted =
        side_by_side(nearest, std::vector<double>(n, 1.0), parts, fewest_side);
    const std::vector<PartStretch> found =
        wanted.empty() ? wanted
                       : balance(wanted, cost, fewest_round, fewest_side + n / (8 * parts));
    if (found.empty()) refuse("they do not lie side by side.");
    return found;
  }

  ActiveCycle merge() {
    const NextCycle& next = next_.front();
    const double length = next.cycle.length();
    const std::vector<PartStretch> stretches = stretches_of_sources(next);
    const auto begin = [&](std::size_t k) {
      return next.cycle.arc[stretches[k % stretches.size()].first];
    };
    const std::vector<int> counts = counts_of(stretches);
    std::vector<std::vector<double>> here(below_.size());  // places, going round each part
    for (std::size_t k = 0; k < stretches.size(); ++k) {
      const double span = forward(begin(k), begin(k + 1), length);
      require_even(span, counts[k]);
      for (int i = 0; i < counts[k]; ++i)
        here[stretches[k].part].push_back(begin(k) + (i + 0.5) * span / counts[k]);
    }
    return add_merged(next, here);
  }

  // How many nodes each stretch gets: middle parts have half of theirs on either side, and one more
  // where that makes the beds' ends fit.
  std::vector<int> counts_of(const std::vector<PartStretch>& stretches) const {
    const std::size_t parts = below_.size();
    std::vector<int> sizes, ends;
    for (std::size_t k = 0; k < parts; ++k)
      sizes.push_back(static_cast<int>(below_[stretches[k].part].nodes.size()));
    std::vector<int> counts = sizes;
    if (parts == 2) return counts;
    for (const int left : {0, -1})
      if (ends.empty()) ends = aligned_ends(sizes, left);
    if (ends.empty()) refuse("their stitches are not even enough in number.");
    counts.resize(stretches.size());
    for (std::size_t k = 1; k + 1 < parts; ++k) {
      counts[k] = (sizes[k] - (ends[k + 1] - ends[k])) / 2;
      counts[stretches.size() - k] = sizes[k] - counts[k];
    }
    return counts;
  }

  // Stretches of the next cycle's pieces by the tube below that is nearest.
  std::vector<PartStretch> stretches_of_sources(const NextCycle& next) const {
    const int m = next.cycle.size();
    std::vector<double> share;
    for (int i = 0; i < m; ++i) share.push_back(next.cycle.arc[i + 1] - next.cycle.arc[i]);
    if (below_.size() > 2) {
      const std::vector<PartStretch> found =
          side_by_side(next.source, share, static_cast<int>(below_.size()),
                       fewest_side * peel_.options.stitch_width);
      if (found.empty()) refuse("they do not lie side by side.");
      return found;
    }
    if (m < 2) refuse("they are too small for this gauge.");
    for (int i = 0; i < m; ++i)
      if (next.source[i] != 0) share[i] = -share[i];
    const Stretch first = best_stretch(share, 1);
    return {{0, first.first, first.count},
            {1, (first.first + first.count) % m, m - first.count}};
  }

  // Many stitches on a short stretch would have to be balanced by force: then two merges are better.
  void require_even(double span, int count) const {
    if (below_.size() == 2) return;
    const double spacing = span / std::max(count, 1) / peel_.options.stitch_width;
    if (spacing < 0.6 || spacing > 1.6)
      refuse("they do not lie across from each other evenly.");
  }

  ActiveCycle add_merged(const NextCycle& next, const std::vector<std::vector<double>>& here) {
    const double length = next.cycle.length();
    struct Link {
      double place;
      int lower;
    };
    std::vector<Link> links;
    for (std::size_t k = 0; k < below_.size(); ++k) {
      const ActiveCycle& active = below_[k];
      const int n = static_cast<int>(active.nodes.size());
      const int shift =
          best_shift(images_on_next(active, static_cast<int>(k), next), here[k], length);
      for (int i = 0; i < n; ++i)
        links.push_back({forward(0.0, here[k][i], length), active.nodes[(i + shift) % n].node});
    }
    std::stable_sort(links.begin(), links.end(),
                     [](const Link& a, const Link& b) { return a.place < b.place; });
    std::vector<double> places;
    for (const Link& link : links) places.push_back(link.place);
    ActiveCycle above = add_row(next, places);
    for (std::size_t i = 0; i < links.size(); ++i)
      peel_.builder.add_column(links[i].lower, above.nodes[i].node);
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
