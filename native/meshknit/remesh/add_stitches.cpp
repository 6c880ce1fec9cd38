#include "meshknit/remesh/add_stitches.h"

#include <array>

#include "meshknit/knit_graph/insert_stitches.h"
#include "meshknit/remesh/stretch.h"

namespace meshknit {
namespace {

// An edge that is stretched more than this, as a fraction of its wanted length, is worth a trial.
constexpr double stretched = 0.12;

// A row or wale is tried along all neighbouring edges where so much of a stitch is missing: first the
// longer way, then the shorter.
constexpr std::array<double, 2> missing = {0.25, 0.6};

// Its ends are moved by so many stitches where they cannot be as they should.
constexpr std::array<int, 6> shifts = {0, 1, -1, 2, -2, 3};

constexpr int longest = 60;

// By how much the sum of squared errors must fall: what two edges have that are a quarter too long.
constexpr double price = 0.12;

constexpr int passes = 3;

// Edges side by side: those after `first` and after the nodes that follow it across the edges.
struct Run {
  int first = -1, size = 0;
};

class StitchAdder {
 public:
  StitchAdder(EditableGraph& graph, SurfaceSprings& points, const StitchSize& size)
      : graph_(graph),
        points_(points),
        stretch_(graph, points, size),
        patch_(graph, points, size) {}

  int pass(const std::function<void(double)>& progress) {
    for (std::vector<char>& tried : tried_) tried.assign(graph_.size(), 0);
    int added = 0;
    const std::vector<StretchedEdge> seeds = stretch_.edges(stretched);
    for (std::size_t k = 0; k < seeds.size(); ++k) {
      if (progress) progress(static_cast<double>(k) / static_cast<double>(seeds.size()));
      const auto [node, kind, error] = seeds[k];
      // What was added before may have mended it.
      if (tried(kind)[node] || stretch_.error(node, kind) <= stretched) continue;
      for (const double least : missing)
        if (kind == EdgeKind::column ? add_row(node, least) : add_wale(node, least)) {
          ++added;
          break;
        }
    }
    return added;
  }

 private:
  std::vector<char>& tried(EdgeKind kind) { return tried_[static_cast<int>(kind)]; }

  // The node whose edge lies beside that of this node: to the left of a column, above a row edge.
  int beside(int node, EdgeKind kind, bool forward) const {
    if (node < 0) return -1;
    if (kind == EdgeKind::column) return forward ? graph_.next(node) : graph_.previous(node);
    return graph_.links(node, forward ? Side::above : Side::below).back();
  }

  int shifted(int node, EdgeKind kind, int by) const {
    for (; by > 0; --by) node = beside(node, kind, true);
    for (; by < 0; ++by) node = beside(node, kind, false);
    return node;
  }

  Run lacking_run(int seed, EdgeKind kind, double least) {
    std::vector<char>& done = tried(kind);
    Run run{seed, 1};
    done[seed] = 1;
    for (const bool forward : {true, false})
      for (int n = beside(seed, kind, forward);
           n >= 0 && n != seed && run.size < longest && stretch_.lack(n, kind) > least;
           n = beside(n, kind, forward), ++run.size) {
        if (n < static_cast<int>(done.size())) done[n] = 1;
        if (!forward) run.first = n;
      }
    return run;
  }

  bool add_row(int seed, double least) {
    Run run = lacking_run(seed, EdgeKind::column, least);
    if (run.size < fewest_between_turns) {
      run.first = shifted(run.first, EdgeKind::column, -1);
      run.size = fewest_between_turns;
    }
    for (const int back : shifts)
      for (const int on : shifts) {
        const int first = shifted(run.first, EdgeKind::column, -back);
        const auto insert = [&] {
          return insert_short_row(graph_, first, run.size + back + on);
        };
        const auto ends = [&](int node) {
          return std::array<int, 2>{graph_.links(node, Side::below).front(),
                                    graph_.links(node, Side::above).front()};
        };
        if (first >= 0 && can(insert)) return pays(insert, ends);
      }
    return false;
  }

  bool add_wale(int seed, double least) {
    const Run run = lacking_run(seed, EdgeKind::row, least);
    for (const int back : shifts)
      for (const int on : shifts) {
        const int first = shifted(run.first, EdgeKind::row, -back);
        if (first < 0) continue;
        for (const Beside a : {Beside::previous, Beside::next})
          for (const Beside b : {Beside::previous, Beside::next}) {
            const auto insert = [&] {
              return insert_wale(graph_, first, run.size + back + on, a, b);
            };
            const auto ends = [&](int node) {
              return std::array<int, 2>{graph_.previous(node), graph_.next(node)};
            };
            if (can(insert)) return pays(insert, ends);
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

  // Inserts stitches, each half way between the nodes that `ends` names, and takes them back if that
  // does not pay.
  template <class Insert, class Ends>
  bool pays(const Insert& insert, const Ends& ends) {
    std::vector<int> near;
    std::vector<FacePoint> places;
    for (const int node : insert()) {
      const auto [a, b] = ends(node);
      near.insert(near.end(), {a, b});
      places.push_back(points_.between(a, b, 0.5));
    }
    // How it was without them is only known without them.
    graph_.undo_change();
    patch_.gather(near);
    const double error_before = patch_.error();
    const std::vector<int> added = insert();
    const int size_before = points_.size();
    for (const FacePoint& place : places) points_.add(place);
    patch_.include(added);
    patch_.relax();
    if (patch_.error() + price < error_before) return true;
    graph_.undo_change();
    points_.shrink(size_before);
    patch_.restore();
    return false;
  }

  EditableGraph& graph_;
  SurfaceSprings& points_;
  Stretch stretch_;
  Patch patch_;
  std::array<std::vector<char>, 2> tried_;  // in this pass: per kind of edge, per node
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
