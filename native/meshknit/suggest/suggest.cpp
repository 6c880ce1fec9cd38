#include "meshknit/suggest/suggest.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <numeric>
#include <optional>
#include <set>

#include "meshknit/core/error.h"
#include "meshknit/suggest/eigenfunctions.h"
#include "meshknit/suggest/opening_radius.h"
#include "meshknit/suggest/rim_times.h"
#include "meshknit/suggest/tips.h"

namespace meshknit {
namespace {

constexpr std::size_t most_tips = 10, most_sets = 4, most_cuts = 3;

// What an order of rims follows: a value per vertex of the mesh as given.
using Ordering = std::vector<double>;

class Search {
 public:
  Search(const VertexArray& vertices, const FaceArray& faces, const CostGauge& gauge,
         RunContext* run)
      : vertices_(vertices), faces_(faces), gauge_(gauge), run_(run) {
    options_.stitch_width = gauge.stitch_width;
    whole_ = make_surface(vertices, faces, options_);
    Problems wrong;
    for (const Problem& problem : whole_.problems)
      if (problem.severity == Severity::error && problem.code != "too-few-boundaries")
        wrong.push_back(problem);
    if (!wrong.empty()) throw NotKnittable(wrong);
  }

  std::vector<Suggestion> best(int count) {
    find_places();
    find_orderings();
    const std::vector<std::size_t> sets = numbers_of_tips();
    for (std::size_t k = 0; k < sets.size(); ++k) {
      report(run_, 0.2 + 0.8 * static_cast<double>(k) / static_cast<double>(sets.size()));
      try_openings(sets[k]);
    }
    std::stable_sort(found_.begin(), found_.end(),
                     [](const Suggestion& a, const Suggestion& b) {
                       return a.cost.total() < b.cost.total();
                     });
    if (static_cast<int>(found_.size()) > count) found_.resize(static_cast<std::size_t>(count));
    if (found_.empty()) refuse();
    report(run_, 1.0);
    return std::move(found_);
  }

 private:
  struct Place {
    int vertex = -1;
    double radius = 0.0, prominence = 0.0;
  };

  [[noreturn]] void refuse() const {
    Problem problem;
    problem.code = "nothing-to-suggest";
    problem.message =
        "No openings and times were found with which this object can be knit at this size and "
        "gauge.";
    problem.remedy =
        "Take a larger object or finer stitches, or mark openings and times by hand where it "
        "is to "
        "begin and end.";
    throw NotKnittable({problem});
  }

  // Tips that can be opened, and more places far from them if there are too few.
  void find_places() {
    const std::vector<Tip> tips = find_tips(whole_.mesh, run_);
    const double least = 4.0 * gauge_.stitch_height;
    for (const Tip& tip : tips)
      if (places_.size() < most_tips && tip.prominence >= least)
        add_place(tip.vertex, tip.prominence);
    report(run_, 0.1);
    for (int more = 0; more < 2 && places_.size() + whole_.boundaries.size() < 2; ++more)
      add_place(far_from_all(), 0.0);
  }

  void add_place(int vertex, double prominence) {
    const double most = std::isfinite(prominence) && prominence > 0.0
                            ? prominence
                            : std::numeric_limits<double>::infinity();
    const double radius =
        radius_for_opening(whole_.mesh, vertex, most, gauge_.stitch_width, whole_.area);
    if (radius > 0.0) places_.push_back({vertex, radius, prominence});
  }

  int far_from_all() const {
    std::vector<int> from;
    for (const Place& place : places_) from.push_back(place.vertex);
    for (const BoundaryLoop& loop : whole_.boundaries) from.push_back(loop.vertices.front());
    if (from.empty()) from.push_back(0);
    return furthest_vertex(whole_.mesh, from);
  }

  void find_orderings() {
    const std::size_t n = whole_.mesh.n_vertices();
    for (int axis = 2; axis >= 0; --axis) {
      Ordering along(n);
      for (std::size_t v = 0; v < n; ++v)
        along[v] = whole_.mesh.point(TriangleMesh::VertexHandle(static_cast<int>(v)))[axis];
      orderings_.push_back(std::move(along));
    }
    for (std::vector<double>& function : low_eigenfunctions(whole_.mesh, 2, run_))
      orderings_.push_back(std::move(function));
    if (!places_.empty())
      orderings_.push_back(distance_to(whole_.mesh, places_.front().vertex));
    report(run_, 0.2);
  }

  // How many tips to open: as few as will do, and where the next one stands out much less.
  std::vector<std::size_t> numbers_of_tips() const {
    const std::size_t rims = whole_.boundaries.size();
    const std::size_t least = rims >= 2 ? 0 : 2 - rims;
    if (places_.size() < least) return {};
    std::vector<std::pair<double, std::size_t>> drops;
    for (std::size_t k = least + 1; k <= places_.size(); ++k) {
      const double next = k < places_.size() ? places_[k].prominence : 0.0;
      drops.push_back({next / std::max(places_[k - 1].prominence, 1e-9), k});
    }
    std::stable_sort(drops.begin(), drops.end());
    std::vector<std::size_t> numbers{least};
    for (const auto& drop : drops)
      if (numbers.size() < most_sets) numbers.push_back(drop.second);
    return numbers;
  }

  void try_openings(std::size_t count) {
    std::vector<OpeningMark> marks;
    std::vector<int> tip;
    for (std::size_t k = 0; k < count; ++k) {
      const Place& place = places_[k];
      marks.push_back(
          {whole_.mesh.point(TriangleMesh::VertexHandle(place.vertex)), place.radius});
      tip.push_back(place.vertex);
    }
    VertexArray vertices = vertices_;
    FaceArray faces = faces_;
    std::vector<Opening> openings;
    if (!marks.empty()) {
      CutSurface cut = cut_openings(vertices_, faces_, {}, marks, options_);
      if (cut.openings.size() != marks.size()) return;
      vertices = std::move(cut.vertices);
      faces = std::move(cut.faces);
      openings = std::move(cut.openings);
    }
    const Surface surface = make_surface(vertices, faces, options_);
    if (has_errors(surface.problems)) return;
    try_orders(surface, marks, openings, tip);
  }

  // Which opening a boundary is the rim of; -1 for the mesh's own.
  static int opening_of(const Surface& surface, const BoundaryLoop& loop,
                        const std::vector<Opening>& openings) {
    for (std::size_t k = 0; k < openings.size(); ++k)
      for (const int row : openings[k].rim)
        if (surface.vertex_of_source[row] == loop.vertices.front()) return static_cast<int>(k);
    return -1;
  }

  void try_orders(const Surface& surface, const std::vector<OpeningMark>& marks,
                  const std::vector<Opening>& openings, const std::vector<int>& tip) {
    const std::size_t rims = surface.boundaries.size();
    std::vector<int> opening;
    for (const BoundaryLoop& loop : surface.boundaries)
      opening.push_back(opening_of(surface, loop, openings));
    const RimTimes rim_times(surface);
    std::set<std::vector<char>> tried;
    for (const Ordering& ordering : orderings_) {
      std::vector<double> value;
      for (std::size_t b = 0; b < rims; ++b)
        value.push_back(opening[b] >= 0
                            ? ordering[tip[opening[b]]]
                            : boundary_mean(surface, surface.boundaries[b], ordering));
      for (std::vector<char>& is_start : cuts_of(value)) {
        turn_round(surface, is_start);
        if (!tried.insert(is_start).second) continue;
        report(run_, 0.0);
        judge(surface, rim_times, is_start, marks, opening);
      }
    }
  }

  // A boundary of the mesh itself is one of the mesh as given, too.
  double boundary_mean(const Surface& surface, const BoundaryLoop& loop,
                       const Ordering& ordering) const {
    double sum = 0.0;
    for (const int v : loop.vertices)
      sum += ordering[static_cast<std::size_t>(
          std::max(whole_.vertex_of_source[surface.source_vertex[v]], 0))];
    return sum / static_cast<double>(loop.vertices.size());
  }

  // The earlier rims of an order are the starts, up to where it leaps furthest.
  static std::vector<std::vector<char>> cuts_of(const std::vector<double>& value) {
    std::vector<std::size_t> order(value.size());
    std::iota(order.begin(), order.end(), std::size_t{0});
    std::stable_sort(order.begin(), order.end(),
                     [&](std::size_t a, std::size_t b) { return value[a] < value[b]; });
    std::vector<std::pair<double, std::size_t>> leaps;
    for (std::size_t k = 1; k < order.size(); ++k)
      leaps.push_back({value[order[k - 1]] - value[order[k]], k});
    std::stable_sort(leaps.begin(), leaps.end());
    if (leaps.size() > most_cuts) leaps.resize(most_cuts);
    std::vector<std::vector<char>> cuts;
    for (const auto& leap : leaps) {
      std::vector<char> is_start(value.size(), 0);
      for (std::size_t k = 0; k < leap.second; ++k) is_start[order[k]] = 1;
      cuts.push_back(std::move(is_start));
    }
    return cuts;
  }

  // Knitting the other way round costs the same but for cast-ons: fewer starts than ends, or else the
  // start at the wider rim.
  static void turn_round(const Surface& surface, std::vector<char>& is_start) {
    std::size_t starts = 0;
    double in = 0.0, out = 0.0;
    for (std::size_t b = 0; b < is_start.size(); ++b) {
      starts += is_start[b] != 0;
      (is_start[b] ? in : out) += surface.boundaries[b].length;
    }
    const std::size_t ends = is_start.size() - starts;
    if (starts < ends || (starts == ends && in >= out)) return;
    for (char& start : is_start) start = start ? 0 : 1;
  }

  void judge(const Surface& surface, const RimTimes& rim_times,
             const std::vector<char>& is_start, const std::vector<OpeningMark>& marks,
             const std::vector<int>& opening) {
    std::vector<double> plain;
    for (const char start : is_start) plain.push_back(start ? -1.0 : 1.0);
    std::optional<Suggestion> best;
    for (const std::vector<double>& times : {rim_times.even_times(is_start), plain}) {
      const std::vector<double> field = rim_times.field(times);
      if (has_errors(check_time_field(surface, field).problems)) continue;
      Suggestion suggestion;
      suggestion.cost = cost_of_field(surface, field, gauge_, run_);
      if (best && !(suggestion.cost.total() < best->cost.total())) continue;
      suggestion.openings = marks;
      for (std::size_t b = 0; b < times.size(); ++b) {
        TimeMark mark;
        mark.time = times[b];
        mark.opening = opening[b];
        if (opening[b] < 0)
          mark.boundary_near = surface.mesh.point(
              TriangleMesh::VertexHandle(surface.boundaries[b].vertices.front()));
        suggestion.times.push_back(mark);
      }
      best = std::move(suggestion);
    }
    if (!best) return;
    best->summary = summary_of(best->cost, marks.size());
    found_.push_back(std::move(*best));
  }

  std::string summary_of(const FieldCost& cost, std::size_t openings) const {
    const auto number = [](double value) { return std::to_string(std::lround(value)); };
    const auto some = [](int n, const std::string& one) {
      return std::to_string(n) + " " + one + (n == 1 ? "" : "s");
    };
    std::string text = some(static_cast<int>(openings), "opening") + ", " +
                       some(cost.starts, "start") + ", " + some(cost.ends, "end");
    if (cost.splits > 0) text += ", " + some(cost.splits, "split");
    if (cost.merges > 0) text += ", " + some(cost.merges, "merge");
    text += "; about " + number(cost.stitches) + " stitches, " +
            number(cost.shaping + 2.0 * cost.short_rows) + " of them irregular, " +
            number(cost.needles) + " of " + std::to_string(gauge_.needles) + " needles";
    if (cost.flat >= 12.0) text += "; rows may not reach parts of it";
    if (!cost.can_hang || cost.tangled > 0) text += "; its tubes would cross";
    if (!cost.fits) text += "; too wide for the machine";
    return text;
  }

  const VertexArray& vertices_;
  const FaceArray& faces_;
  CostGauge gauge_;
  RunContext* run_;
  SurfaceOptions options_;
  Surface whole_;
  std::vector<Place> places_;
  std::vector<Ordering> orderings_;
  std::vector<Suggestion> found_;
};

}  // namespace

std::vector<Suggestion> suggest_marks(const VertexArray& vertices, const FaceArray& faces,
                                      const CostGauge& gauge, int count, RunContext* run) {
  if (!(gauge.stitch_width > 0.0) || !(gauge.stitch_height > 0.0) || gauge.needles < 1)
    throw InvalidInput("suggest_marks: stitch width, height and needles must be positive");
  return Search(vertices, faces, gauge, run).best(count);
}

}  // namespace meshknit
