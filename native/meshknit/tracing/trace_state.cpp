#include "meshknit/tracing/trace_state.h"

#include <algorithm>
#include <utility>

namespace meshknit {

TraceState::TraceState(const KnitGraph& graph)
    : graph_(graph),
      walk_(graph),
      loops_(graph.nodes.size()),
      times_knit_(graph.nodes.size(), 0),
      waiting_(graph.rows.size(), 0),
      begun_(graph.rows.size(), false),
      tubes_(find_tubes(graph)) {
  for (const KnitRow& row : graph.rows)
    unfinished_.push_back(static_cast<int>(row.nodes.size()));
  for (const auto& column : graph.columns) ++waiting_[walk_.place(column[1]).row];
  trace_.stitches.reserve(2 * graph.nodes.size() + 2 * graph.rows.size());
  trace_.courses = 2 * static_cast<int>(graph.rows.size());
  trace_.tubes = tubes_.count;
}

int TraceState::ahead(int node, Direction direction) const {
  return direction == Direction::anticlockwise ? walk_.next(node) : walk_.previous(node);
}

int TraceState::loop_ahead() const {
  const NodeLoops& own = loops_[node_];
  return direction_ == Direction::anticlockwise ? ring_.next(own.loop[own.count - 1])
                                                : ring_.previous(own.loop[0]);
}

int TraceState::node_due_ahead() const {
  const int loop = loop_ahead();
  const int node = trace_.stitches[owners_[loop].stitch].node;
  if (times_knit_[node] == 1) return node;
  const std::vector<int>& above = walk_.above(node);
  if (above.empty()) return -1;
  const bool second = above.size() == 2 && loops_[node].loop[1] == loop;
  const int due = above[second ? 1 : 0];
  return begun_[walk_.place(due).row] ? due : -1;
}

void TraceState::begin_yarn() { yarn_ = trace_.yarns++; }

void TraceState::take_up(const YarnEnd& yarn) {
  yarn_ = yarn.yarn;
  node_ = yarn.node;
  direction_ = yarn.direction;
}

int TraceState::loop_under(int below, int node) const {
  const std::vector<int>& above = walk_.above(below);
  const bool second = above.size() == 2 && above[1] == node;
  return loops_[below].loop[second ? 1 : 0];
}

std::vector<int> TraceState::loops_under(int node) const {
  if (times_knit_[node] == 1) return {loops_[node].loop[0]};
  std::vector<int> loops;
  for (const int below : walk_.below(node)) loops.push_back(loop_under(below, node));
  return loops;
}

void TraceState::close_ring_under(int row) {
  std::vector<int> ring;
  for (const int node : graph_.rows[row].nodes) {
    const std::vector<int> loops = loops_under(node);
    ring.insert(ring.end(), loops.begin(), loops.end());
  }
  ring_.join(ring);
}

void TraceState::hang_new_loops(int node, int stitch, const std::vector<int>& knit_through) {
  const int slots = static_cast<int>(trace_.stitches[stitch].children.size());
  NodeLoops& loops = loops_[node];
  loops.count = std::max(1, slots);
  for (int k = 0; k < loops.count; ++k) {
    const int before = walk_.previous(node);
    if (k > 0) {
      loops.loop[k] = ring_.add_after(loops.loop[k - 1]);
    } else if (!knit_through.empty()) {
      loops.loop[k] = ring_.add_after(knit_through.back());
    } else if (times_knit_[before] > 0) {
      loops.loop[k] = ring_.add_after(loops_[before].loop[0]);
    } else {
      loops.loop[k] = ring_.add_alone();
    }
    // An increase knits first and then makes its second loop ahead of that, in its own
    // direction.
    const bool knit_comes_first = direction_ == Direction::anticlockwise;
    owners_.push_back({stitch, knit_comes_first ? k : loops.count - 1 - k, {}});
  }
  for (const int loop : knit_through) ring_.take_off(loop);
}

void TraceState::knit(int node, Direction direction) {
  const int row = walk_.place(node).row;
  if (!begun_[row] && graph_.rows[row].closed) close_ring_under(row);
  begun_[row] = true;

  const int index = static_cast<int>(trace_.stitches.size());
  const bool first = times_knit_[node] == 0;
  const std::vector<int> through = loops_under(node);
  const std::size_t loops_above = first ? 1 : walk_.above(node).size();
  Stitch stitch;
  stitch.yarn = yarn_;
  stitch.tube = tubes_.of_row[row];
  stitch.direction = direction;
  stitch.node = node;
  stitch.children.assign(loops_above, -1);
  if (through.empty()) {
    stitch.kind = StitchKind::start;
  } else if (through.size() == 2) {
    stitch.kind = StitchKind::decrease;
  } else if (loops_above == 0) {
    stitch.kind = StitchKind::end;
  } else if (loops_above == 2) {
    stitch.kind = StitchKind::increase;
  }

  std::vector<int> met = through;
  if (direction == Direction::clockwise) std::reverse(met.begin(), met.end());
  for (const int loop : met) {
    const LoopOwner& owner = owners_[loop];
    stitch.parents.push_back(owner.stitch);
    trace_.stitches[owner.stitch].children[owner.child_slot] = index;
    for (const int tuck : owner.tucks) {
      stitch.parents.push_back(tuck);
      trace_.stitches[tuck].children = {index};
    }
  }
  trace_.stitches.push_back(std::move(stitch));

  node_ = node;
  direction_ = direction;
  hang_new_loops(node, index, through);
  ++times_knit_[node];
  if (first) return;
  --unfinished_[row];
  for (const int above : walk_.above(node)) --waiting_[walk_.place(above).row];
}

void TraceState::tuck() {
  LoopOwner& owner = owners_[loop_ahead()];
  Stitch stitch;
  stitch.yarn = yarn_;
  stitch.tube = trace_.stitches.back().tube;
  stitch.kind = StitchKind::tuck;
  stitch.direction = direction_;
  stitch.node = trace_.stitches[owner.stitch].node;
  owner.tucks.push_back(static_cast<int>(trace_.stitches.size()));
  trace_.stitches.push_back(std::move(stitch));
}

StitchTrace TraceState::take_trace() { return std::move(trace_); }

}  // namespace meshknit
