// The yarn's way, replayed stitch by stitch on a ring of hanging loops.

#include <algorithm>
#include <string>
#include <utility>

#include "meshknit/knit_graph/rows.h"
#include "meshknit/tracing/knit_twice.h"
#include "meshknit/tracing/loop_ring.h"
#include "meshknit/tracing/trace_promises.h"

namespace meshknit {
namespace {

class YarnReplay {
 public:
  YarnReplay(const KnitGraph& graph, const StitchTrace& trace)
      : graph_(graph),
        trace_(trace),
        walk_(graph),
        knit_(find_stitches(graph, trace)),
        loops_(trace.stitches.size()),
        last_(trace.yarns, -1),
        before_last_(trace.yarns, -1),
        begun_(graph.rows.size(), false),
        turns_(graph.rows.size()) {}

  Problems run() {
    for (int s = 0; s < static_cast<int>(trace_.stitches.size()); ++s) {
      trace_.stitches[s].kind == StitchKind::tuck ? replay_tuck(s) : replay_knit(s);
      const int yarn = trace_.stitches[s].yarn;
      before_last_[yarn] = last_[yarn];
      last_[yarn] = s;
    }
    for (const int s : last_)
      if (s >= 0 && is_tuck(s))
        report("tuck-misplaced", "The yarn ends with tuck " + std::to_string(s) + ".", {s});
    count_turns();
    return std::move(problems_);
  }

 private:
  const Stitch& stitch(int s) const { return trace_.stitches[s]; }
  bool is_tuck(int s) const { return stitch(s).kind == StitchKind::tuck; }
  static bool is_anticlockwise(const Stitch& s) {
    return s.direction == Direction::anticlockwise;
  }

  void report(const std::string& code, const std::string& message, std::vector<int> stitches) {
    problems_.push_back(stitch_problem(trace_, code, message, std::move(stitches)));
  }

  /// The loop of `parent` that `child` knits through.
  int loop_for(int parent, int child) const {
    const std::vector<int>& children = stitch(parent).children;
    const auto slot = std::find(children.begin(), children.end(), child) - children.begin();
    return loops_[parent][slot];
  }

  /// The loops that a stitch knits through, anticlockwise.
  std::vector<int> knit_through(int s) const {
    std::vector<int> loops;
    for (const int parent : loop_parents(trace_, s)) loops.push_back(loop_for(parent, s));
    if (!is_anticlockwise(stitch(s))) std::reverse(loops.begin(), loops.end());
    return loops;
  }

  /// The stitch that will knit through a loop; -1 if none will.
  int child_of(int loop) const {
    const auto [s, slot] = owners_[loop];
    return slot < static_cast<int>(stitch(s).children.size()) ? stitch(s).children[slot] : -1;
  }

  /// The loop of a stitch that lies furthest in a direction.
  int foremost(int s) const {
    // Slots are in the stitch's own direction, in which its yarn goes on.
    return loops_[s].back();
  }

  int neighbour(int loop, Direction direction) const {
    return direction == Direction::anticlockwise ? ring_.next(loop) : ring_.previous(loop);
  }

  void replay_knit(int s) {
    const Stitch& made = stitch(s);
    const int row = walk_.place(made.node).row;
    if (graph_.rows[row].closed && !is_anticlockwise(made))
      report("closed-row-reversed",
             "Stitch " + std::to_string(s) + " is made clockwise in a closed row.", {s});
    if (graph_.rows[row].closed && !begun_[row]) close_ring_under(row);
    begun_[row] = true;

    const std::vector<int> through = knit_through(s);
    check_step(s, through);
    hang(s, through);
  }

  /// A closed row makes a tube of its own of what it stands on.
  void close_ring_under(int row) {
    std::vector<int> ring;
    for (const int node : graph_.rows[row].nodes)
      for (const int below : walk_.below(node))
        // The second stitch below may be missing yet in a broken trace.
        if (!loops_[knit_.second[below]].empty())
          ring.push_back(loop_for(knit_.second[below], knit_.first[node]));
    ring_.join(ring);
  }

  void check_step(int s, const std::vector<int>& through) {
    const int last = last_[stitch(s).yarn];
    if (last < 0) return;
    if (is_tuck(last)) {
      check_turn(s, last, through);
      return;
    }
    bool goes_on = stitch(s).direction == stitch(last).direction;
    if (through.empty()) {
      const int node = stitch(last).node;
      goes_on = goes_on && walk_.next(node) == stitch(s).node;
    } else if (goes_on) {
      goes_on = hangs(last) && std::count(through.begin(), through.end(), loop_ahead(last)) > 0;
    }
    if (!goes_on)
      report("yarn-jumps",
             "The yarn goes from stitch " + std::to_string(last) + " to stitch " +
                 std::to_string(s) + ", which is not made beside it.",
             {last, s});
  }

  bool hangs(int s) const { return ring_.hangs(foremost(s)); }

  /// The next loop ahead of a stitch that is not decreased together with its own.
  int loop_ahead(int s) const {
    const int own = foremost(s);
    const Direction direction = stitch(s).direction;
    int ahead = neighbour(own, direction);
    while (ahead != own && child_of(ahead) >= 0 && child_of(ahead) == child_of(own))
      ahead = neighbour(ahead, direction);
    return ahead;
  }

  void replay_tuck(int s) {
    const int last = last_[stitch(s).yarn];
    const bool after_stitch = last >= 0 && !is_tuck(last) && hangs(last) &&
                              stitch(last).direction == stitch(s).direction;
    if (after_stitch) {
      const int beside = neighbour(foremost(last), stitch(s).direction);
      const int child = stitch(s).children.front();
      if (child == child_of(beside) && stitch_tucked_on(s, child) == owners_[beside].stitch)
        return;
    }
    report("tuck-misplaced",
           "Tuck " + std::to_string(s) +
               " does not lie on the loop beside its yarn's last stitch.",
           {s});
  }

  /// The parent behind which a tuck stands.
  int stitch_tucked_on(int tuck, int child) const {
    int loop_parent = -1;
    for (const int parent : stitch(child).parents) {
      if (parent == tuck) return loop_parent;
      if (!is_tuck(parent)) loop_parent = parent;
    }
    return -1;
  }

  void check_turn(int s, int tuck, const std::vector<int>& through) {
    const int last = before_last_[stitch(s).yarn];
    const bool comes_back = stitch(s).direction != stitch(tuck).direction && last >= 0 &&
                            !is_tuck(last) &&
                            std::count(through.begin(), through.end(), foremost(last)) > 0;
    const auto [row, index] = walk_.place(stitch(s).node);
    const int size = static_cast<int>(graph_.rows[row].nodes.size());
    const bool forward = is_anticlockwise(stitch(tuck));
    const bool at_end = !graph_.rows[row].closed && index == (forward ? size - 1 : 0);
    if (comes_back && at_end) {
      ++(forward ? turns_[row].at_last : turns_[row].at_first);
    } else {
      report("tuck-misplaced",
             "After tuck " + std::to_string(tuck) +
                 " the yarn does not turn at the end of a short row.",
             {tuck, s});
    }
  }

  void hang(int s, const std::vector<int>& through) {
    const int count = std::max<int>(1, static_cast<int>(stitch(s).children.size()));
    std::vector<int> made;
    const int before = walk_.previous(stitch(s).node);
    for (int k = 0; k < count; ++k) {
      if (k > 0) {
        made.push_back(ring_.add_after(made.back()));
      } else if (!through.empty()) {
        made.push_back(ring_.add_after(through.back()));
      } else if (before >= 0 && begun_at(before)) {
        made.push_back(ring_.add_after(loops_[knit_.first[before]].back()));
      } else {
        made.push_back(ring_.add_alone());
      }
    }
    if (!is_anticlockwise(stitch(s))) std::reverse(made.begin(), made.end());
    owners_.resize(owners_.size() + made.size());
    for (int k = 0; k < count; ++k) owners_[made[k]] = {s, k};
    loops_[s] = std::move(made);
    for (const int loop : through) ring_.take_off(loop);
  }

  bool begun_at(int node) const {
    const std::vector<int>& loops = loops_[knit_.first[node]];
    return !loops.empty() && ring_.hangs(loops.back());
  }

  void count_turns() {
    for (int row = 0; row < static_cast<int>(turns_.size()); ++row) {
      if (graph_.rows[row].closed) continue;
      for (const int turns : {turns_[row].at_first, turns_[row].at_last}) {
        if (turns == 1) continue;
        Problem problem = stitch_problem(
            trace_, turns == 0 ? "turn-missing" : "turn-repeated",
            "Short row " + std::to_string(row) + " has " + std::to_string(turns) +
                " tucks and turns at one of its ends instead of one.",
            {});
        problem.elements.nodes = graph_.rows[row].nodes;
        problems_.push_back(problem);
      }
    }
  }

  struct Owner {
    int stitch = -1;
    int slot = 0;
  };
  struct Turns {
    int at_first = 0, at_last = 0;
  };

  const KnitGraph& graph_;
  const StitchTrace& trace_;
  RowWalk walk_;
  KnitTwice knit_;
  LoopRing ring_;
  std::vector<Owner> owners_;            ///< [loop]
  std::vector<std::vector<int>> loops_;  ///< [stitch], in the stitch's own direction
  std::vector<int> last_, before_last_;  ///< [yarn]
  std::vector<bool> begun_;              ///< [row]
  std::vector<Turns> turns_;             ///< [row]
  Problems problems_;
};

}  // namespace

Problems check_yarn_path(const KnitGraph& graph, const StitchTrace& trace) {
  return YarnReplay(graph, trace).run();
}

}  // namespace meshknit
