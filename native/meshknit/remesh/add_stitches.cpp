#include "meshknit/remesh/add_stitches.h"

#include <algorithm>
#include <array>

#include "meshknit/knit_graph/insert_stitches.h"

namespace meshknit {
namespace {

// An edge that is stretched more than this, as a fraction of its wanted length, is worth a trial.
constexpr double stretched = 0.12;

// Relaxation has spread the error of a missing stitch: it is summed up over so many edges each way.
constexpr int reach = 4;

// A row or wale is tried along all neighbouring stitches of which so much is missing.
constexpr std::array<double, 2> missing = {0.25, 0.6};

// Its ends are moved by so many stitches where they cannot be as they should.
constexpr std::array<int, 6> shifts = {0, 1, -1, 2, -2, 3};

constexpr int longest = 60;

// By how much the sum of squared errors must fall: as much as two edges have that are a quarter too long.
constexpr double price = 0.12;

constexpr int passes = 3;

// Nodes in a row, or one above the other.
struct Run {
  int first = -1, size = 0;
};

class StitchAdder {
 public:
  StitchAdder(EditableGraph& graph, SurfaceSprings& points, const StitchSize& size)
      : graph_(graph), points_(points), size_(size), patch_(graph, points, size) {}

  int pass(const std::function<void(double)>& progress) {
    row_tried_.assign(graph_.size(), 0);
    wale_tried_.assign(graph_.size(), 0);
    int added = 0;
    const std::vector<Seed> seeds = stretched_edges();
    for (std::size_t k = 0; k < seeds.size(); ++k) {
      if (progress) progress(static_cast<double>(k) / static_cast<double>(seeds.size()));
      const Seed& seed = seeds[k];
      std::vector<char>& tried = seed.column ? row_tried_ : wale_tried_;
      if (tried[seed.node] || error(seed.node, seed.column) <= stretched) continue;
      for (const double least : missing)
        if (seed.column ? add_row(seed.node, least) : add_wale(seed.node, least)) {
          ++added;
          break;
        }
    }
    return added;
  }

 private:
  // The edge after a node, in its row or up its column.
  struct Seed {
    int node;
    bool column;
    double error;
  };

  int after(int node, bool column) const {
    return column ? graph_.links(node, Side::above).front() : graph_.next(node);
  }
  int before(int node, bool column) const {
    return column ? graph_.links(node, Side::below).front() : graph_.previous(node);
  }
  double error(int node, bool column) const {
    const int to = after(node, column);
    return to < 0 ? -1.0 : points_.error({node, to, column ? size_.height : size_.width});
  }

  std::vector<Seed> stretched_edges() const {
    std::vector<Seed> seeds;
    for (int node = 0; node < graph_.size(); ++node)
      for (const bool column : {true, false}) {
        const double e = error(node, column);
        if (e > stretched) seeds.push_back({node, column, e});
      }
    std::stable_sort(seeds.begin(), seeds.end(),
                     [](const Seed& a, const Seed& b) { return a.error > b.error; });
    return seeds;
  }

  // Part of a stitch that is missing at the edge after a node and before and after that.
  double lack(int node, bool column) const {
    double sum = 0.0;
    for (int k = 0, at = node; k < reach && after(at, column) >= 0; ++k) {
      sum += error(at, column);
      at = after(at, column);
    }
    for (int k = 1, at = before(node, column); k < reach && at >= 0; ++k) {
      sum += error(at, column);
      at = before(at, column);
    }
    return sum;
  }

  // The node whose column (or row edge) lies next to that of this node.
  int beside(int node, bool column, bool forward) const {
    if (node < 0) return -1;
    if (column) return forward ? graph_.next(node) : graph_.previous(node);
    const Side side = forward ? Side::above : Side::below;
    return graph_.links(node, side).back();
  }

  int shifted(int node, bool column, int by) const {
    for (; by > 0; --by) node = beside(node, column, true);
    for (; by < 0; ++by) node = beside(node, column, false);
    return node;
  }

  Run lacking_run(int seed, bool column, double least) {
    std::vector<char>& tried = column ? row_tried_ : wale_tried_;
    Run run{seed, 1};
    tried[seed] = 1;
    for (const bool forward : {true, false})
      for (int n = beside(seed, column, forward);
           n >= 0 && n != seed && run.size < longest && lack(n, column) > least;
           n = beside(n, column, forward), ++run.size) {
        if (n < static_cast<int>(tried.size())) tried[n] = 1;
        if (!forward) run.first = n;
      }
    return run;
  }

  bool add_row(int seed, double least) {
    Run run = lacking_run(seed, true, least);
    if (run.size < fewest_between_turns) {
      run.first = shifted(run.first, true, -1);
      run.size = fewest_between_turns;
    }
    for (const int down : shifts)
      for (const int up : shifts) {
        const int first = shifted(run.first, true, -down);
        if (first < 0) continue;
        const auto insert = [&] {
          return insert_short_row(graph_, first, run.size + down + up, Side::above);
        };
        const auto ends = [&](int n) {
          return std::array<int, 2>{graph_.links(n, Side::below).front(),
                                    graph_.links(n, Side::above).front()};
        };
        if (can(insert)) return worth(insert, ends);
      }
    return false;
  }

  bool add_wale(int seed, double least) {
    const Run run = lacking_run(seed, false, least);
    for (const int down : shifts)
      for (const int up : shifts) {
        const int first = shifted(run.first, false, -down);
        if (first < 0) continue;
        for (const Beside a : {Beside::previous, Beside::next})
          for (const Beside b : {Beside::previous, Beside::next}) {
            const auto insert = [&] {
              return insert_wale(graph_, first, run.size + down + up, a, b);
            };
            const auto ends = [&](int n) {
              return std::array<int, 2>{graph_.previous(n), graph_.next(n)};
            };
            if (can(insert)) return worth(insert, ends);
          }
      }
    return false;
  }

  template <class Insert>
  bool can(const Insert& insert) {
    graph_.begin_change();
    const bool done = !insert().empty();
    graph_.undo_change();
    return done;
  }

  // Inserts stitches, each between the nodes that `ends` names, and takes them back if that does not pay.
  template <class Insert, class Ends>
  bool worth(const Insert& insert, const Ends& ends) {
    std::vector<int> added = insert(), near;
    const int size = points_.size();
    std::vector<FacePoint> places;
    for (const int n : added) {
      // Other new nodes have no place yet.
      for (const int end : ends(n)) near.push_back(end);
      places.push_back(points_.between(near[near.size() - 2], near.back(), 0.5));
    }
    graph_.undo_change();
    patch_.gather(near);
    const double error_before = patch_.error();
    added = insert();
    for (const FacePoint& place : places) points_.add(place);
    patch_.include(added);
    patch_.relax();
    if (patch_.error() + price < error_before) return true;
    graph_.undo_change();
    points_.shrink(size);
    patch_.restore();
    return false;
  }

  EditableGraph& graph_;
  SurfaceSprings& points_;
  StitchSize size_;
  Patch patch_;
  std::vector<char> row_tried_, wale_tried_;  // in this pass
};

}  // namespace

int add_stitches(EditableGraph& graph, SurfaceSprings& points, const StitchSize& size,
                 const std::function<void(double)>& progress) {
  StitchAdder adder(graph, points, size);
  int added = 0;
  for (int k = 0; k < passes; ++k) {
    const int more = adder.pass([&](double fraction) {
      if (progress) progress((k + fraction) / passes);
    });
    if (more == 0) break;
    added += more;
  }
  return added;
}

}  // namespace meshknit
