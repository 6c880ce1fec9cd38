#include "meshknit/suggest/field_cost.h"

#include <algorithm>
#include <cmath>

#include "meshknit/tracing/hanging_order.h"

namespace meshknit {
namespace {

constexpr int levels = 96;

// Time must step by at least this part of what it does elsewhere in the row.
constexpr double least_step = 0.25;

// Prices in irregular stitches.
constexpr double price_of_saddle = 12.0, price_of_start = 12.0, price_of_rim = 10.0;
constexpr double price_of_flat = 3.0, forbidden = 1e9;

// Places of a bed at half gauge are two needles wide; tubes hang this many needles apart, and as many
// stay free at the bed's ends.
constexpr double needles_between = 4.0;

// Where a level set goes through a triangle.
struct Piece {
  double slowness = 0.0;  // mm of surface per unit of time
  double length = 0.0;    // mm
  int face = -1;
};

struct LevelSet {
  std::vector<Piece> pieces;
  double girth = 0.0;  // mm

  // The slowness that this part of the length lies below. Requires: sorted pieces.
  double slowness_at(double part) const {
    double below = 0.0;
    for (const Piece& piece : pieces) {
      below += piece.length;
      if (below >= part * girth) return piece.slowness;
    }
    return pieces.back().slowness;
  }
};

// The gradient of time over a triangle, per mm.
double gradient_length(const Eigen::Vector3d corner[3], const double t[3], double area) {
  const Eigen::Vector3d normal =
      (corner[1] - corner[0]).cross(corner[2] - corner[0]).normalized();
  Eigen::Vector3d sum = Eigen::Vector3d::Zero();
  for (int k = 0; k < 3; ++k)
    sum += t[k] * normal.cross(corner[(k + 2) % 3] - corner[(k + 1) % 3]);
  return sum.norm() / (2.0 * area);
}

class Judge {
 public:
  Judge(const Surface& surface, const std::vector<double>& time, const CostGauge& gauge,
        RunContext* run)
      : mesh_(surface.mesh),
        time_(time),
        gauge_(gauge),
        row_height_(2.0 * gauge.stitch_height),
        reeb_(reeb_graph(surface.mesh, time, run)),
        first_(*std::min_element(time.begin(), time.end())),
        span_(*std::max_element(time.begin(), time.end()) - first_),
        sets_(reeb_.arcs.size() * levels),
        girth_(levels, 0.0),
        held_(levels, 0) {}

  FieldCost run() {
    count_events();
    walk_faces();
    for (std::size_t arc = 0; arc < reeb_.arcs.size(); ++arc) add_tube(static_cast<int>(arc));
    measure_width();
    cost_.can_hang = can_hang(tubes());
    return cost_;
  }

 private:
  LevelSet& level_set(int arc, int k) {
    return sets_[static_cast<std::size_t>(arc) * levels + static_cast<std::size_t>(k)];
  }
  double level(int k) const { return first_ + (k + 0.5) * span_ / levels; }
  double area_of_node() const { return gauge_.stitch_width * row_height_; }

  void count_events() {
    cost_.slowness.assign(mesh_.n_faces(), 1.0);
    for (const ReebEvent& event : reeb_.events) {
      const int below = static_cast<int>(event.below.size());
      const int above = static_cast<int>(event.above.size());
      cost_.starts += below == 0;
      cost_.ends += above == 0;
      if (below == 0 || above == 0) continue;
      cost_.saddles.push_back({mesh_.point(TriangleMesh::VertexHandle(event.vertices.front())),
                               event.time, below, above});
      cost_.splits += above - 1;
      cost_.merges += below - 1;
      cost_.tangled += std::min(below, above) > 1 || event.index != 2 - below - above;
    }
  }

  void walk_faces() {
    for (const auto f : mesh_.faces()) {
      Eigen::Vector3d corner[3];
      double t[3];
      int arc[3], k = 0;
      for (const auto v : mesh_.fv_range(f)) {
        corner[k] = mesh_.point(v);
        t[k] = time_[v.idx()];
        arc[k++] = reeb_.arc_of_vertex[v.idx()];
      }
      const double area = mesh_.calc_face_area(f);
      cost_.stitches += 2.0 * area / area_of_node();
      const double low = std::min({t[0], t[1], t[2]}), high = std::max({t[0], t[1], t[2]});
      const double gradient = gradient_length(corner, t, area);
      if (!(gradient > 0.0) || !(high > low)) {
        cost_.flat += area / area_of_node();
        continue;
      }
      const double width = span_ / levels;
      const int from = std::max(0, static_cast<int>((low - first_) / width - 0.5));
      const int to = std::min(levels - 1, static_cast<int>((high - first_) / width + 0.5));
      for (int l = from; l <= to; ++l) {
        const double length = crossing_length(corner, t, level(l));
        const int tube = length > 0.0 ? tube_at(arc, level(l)) : -1;
        if (tube < 0) continue;
        level_set(tube, l).pieces.push_back({1.0 / gradient, length, f.idx()});
        level_set(tube, l).girth += length;
      }
    }
  }

  static double crossing_length(const Eigen::Vector3d corner[3], const double t[3], double at) {
    Eigen::Vector3d end[2];
    int ends = 0;
    for (int i = 0; i < 3; ++i) {
      const int j = (i + 1) % 3;
      if ((t[i] < at) == (t[j] < at) || ends == 2) continue;
      end[ends++] = corner[i] + (at - t[i]) / (t[j] - t[i]) * (corner[j] - corner[i]);
    }
    return ends == 2 ? (end[1] - end[0]).norm() : 0.0;
  }

  // The tube that a level set belongs to in a triangle: that of a corner, if the tube is there at this
  // time; else any that is.
  int tube_at(const int arc[3], double at) const {
    const auto is_there = [&](int tube) {
      return reeb_.events[reeb_.arcs[tube].from].time <= at &&
             at <= reeb_.events[reeb_.arcs[tube].to].time;
    };
    for (int k = 0; k < 3; ++k)
      if (arc[k] >= 0 && is_there(arc[k])) return arc[k];
    for (int tube = 0; tube < static_cast<int>(reeb_.arcs.size()); ++tube)
      if (is_there(tube)) return tube;
    return -1;
  }

  void add_tube(int arc) {
    double last = 0.0;
    for (int l = 0; l < levels; ++l) {
      LevelSet& own = level_set(arc, l);
      if (own.pieces.empty()) continue;
      std::sort(own.pieces.begin(), own.pieces.end(),
                [](const Piece& x, const Piece& y) { return x.slowness < y.slowness; });
      if (last > 0.0) cost_.shaping += std::abs(own.girth - last) / gauge_.stitch_width;
      last = own.girth;
      girth_[l] += own.girth;
      ++held_[l];
      const double step = span_ / levels, middle = own.slowness_at(0.5);
      cost_.short_rows += step * (own.slowness_at(0.9) - own.slowness_at(0.1)) / row_height_;
      for (const Piece& piece : own.pieces) {
        double& slowness = cost_.slowness[static_cast<std::size_t>(piece.face)];
        slowness = std::max(slowness, piece.slowness / middle);
        if (piece.slowness * least_step > middle)
          cost_.flat += piece.length * piece.slowness * step / area_of_node();
      }
    }
  }

  void measure_width() {
    for (int l = 0; l < levels; ++l) {
      // Half of a tube's loops hang on each bed, two needles a loop.
      const double loops = girth_[l] / gauge_.stitch_width;
      cost_.needles = std::max(cost_.needles, loops + needles_between * (held_[l] + 1));
    }
    cost_.fits = cost_.needles <= gauge_.needles;
  }

  std::vector<TubeLinks> tubes() const {
    std::vector<TubeLinks> links(reeb_.arcs.size());
    for (const ReebEvent& event : reeb_.events) {
      for (const int arc : event.above) {
        links[arc].begin = event.time;
        links[arc].below = event.below;
      }
      for (const int arc : event.below) {
        links[arc].end = event.time;
        links[arc].above = event.above;
      }
    }
    return links;
  }

  const TriangleMesh& mesh_;
  const std::vector<double>& time_;
  CostGauge gauge_;
  double row_height_;
  ReebGraph reeb_;
  double first_, span_;
  std::vector<LevelSet> sets_;  // [arc][level]
  std::vector<double> girth_;   // [level] of all tubes together, mm
  std::vector<int> held_;       // [level] tubes
  FieldCost cost_;
};

}  // namespace

double FieldCost::total() const {
  // A short row has two ends.
  double sum = shaping + 2.0 * short_rows + price_of_flat * flat +
               price_of_saddle * (splits + merges) + price_of_start * starts +
               price_of_rim * (starts + ends);
  if (!can_hang || tangled > 0 || !fits) sum += forbidden;
  return sum;
}

FieldCost cost_of_field(const Surface& surface, const std::vector<double>& time,
                        const CostGauge& gauge, RunContext* run) {
  return Judge(surface, time, gauge, run).run();
}

}  // namespace meshknit
