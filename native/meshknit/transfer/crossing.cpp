#include "meshknit/transfer/crossing.h"

#include <algorithm>
#include <array>
#include <cstdlib>
#include <functional>
#include <limits>
#include <map>
#include <queue>
#include <tuple>
#include <utility>

namespace meshknit {
namespace {

// Indices of runs count on round the tube without end, their sides with them. A stretch of
// them grows (expand: those that have gone) or shrinks (collapse: those that are still to go) one
// stack at a time at either end. Who hangs where matters only beside its ends.
class CrossingSearch {
 public:
  CrossingSearch(const CollapsingTube& state, Crossing crossing)
      : state_(state),
        count_(state.count()),
        collapse_(crossing == Crossing::collapse),
        from_(bed_of_side(state.hanging[0].stack.side)) {
    if (!collapse_ && state.top == 0) from_ = opposite(from_);
    for (int i = 0; i < count_; ++i) list_targets(i);
    Node start;
    start.pass = state.pass;
    start.last = collapse_ ? state.top : 0;
    if (collapse_) add(start);
    for (int i = state.top; i < count_ && !collapse_; ++i) {
      start.first = start.last = i;
      add(start);
    }
    while (goal_ < 0 && !open_.empty()) {
      const auto [cost, at] = open_.top();
      open_.pop();
      const Node node = nodes_[at];  // the list grows below
      if (best_[key(node)] < cost) continue;
      if (node.closed)
        goal_ = at;
      else
        follow(node, at);
    }
  }

  bool found() const { return goal_ >= 0; }

  void apply(CollapsingTube& state) const {
    std::vector<const Node*> moves;
    for (int at = goal_; at >= 0; at = nodes_[at].before)
      if (nodes_[at].mover >= 0) moves.push_back(&nodes_[at]);
    std::reverse(moves.begin(), moves.end());
    for (const Node* move : moves) {
      append_move(state, state.hanging[move->mover], move->target);
      state.pass = move->pass;
    }
  }

 private:
  // Way that is left beyond the least that each stack could have, and passes.
  using Cost = std::pair<long, int>;

  struct Node {
    int first = 0, last = 0;               // the run: first to last - 1
    Stop beside_first, beside_last;        // of the stacks that went last at either end
    Stop outermost_first, outermost_last;  // of a collapse: of the two that went first
    std::optional<Pass> pass;              // the last one
    Cost cost;
    bool closed = false;
    int before = -1;  // the node that this one follows, and who moved where to come here
    int mover = -1;
    Stop target;
  };

  struct Target {
    Pass pass;
    Stop stop;
    long way;
  };

  using Key = std::tuple<bool, int, int, std::array<int, 12>, int>;
  Key key(const Node& node) const {
    // The two that went first matter only where no stack hung on the other bed between them.
    const bool alone = collapse_ && state_.top == count_;
    std::array<int, 12> stops{};
    int k = 0;
    for (const Stop& stop :
         {node.beside_first, node.beside_last, alone ? node.outermost_first : Stop{},
          alone ? node.outermost_last : Stop{}}) {
      stops[k++] = stop.side;
      stops[k++] = stop.place;
      stops[k++] = stop.parked;
    }
    const int racking = node.pass ? node.pass->racking : std::numeric_limits<int>::max();
    return {node.closed, node.first, node.last, stops, racking};
  }

  void add(const Node& node) {
    const auto [entry, fresh] = best_.emplace(key(node), node.cost);
    if (!fresh && entry->second <= node.cost) return;
    entry->second = node.cost;
    open_.push({node.cost, static_cast<int>(nodes_.size())});
    nodes_.push_back(node);
  }

  // The stack of an index, and how often the index went round the tube to it.
  std::pair<int, int> stack_and_turns(int i) const {
    const int stack = (i % count_ + count_) % count_;
    return {stack, (i - stack) / count_};
  }
  const HangingRun& run(int i) const { return state_.hanging[stack_and_turns(i).first]; }
  const Stack& stack(int i) const { return run(i).stack; }

  // Where the last stack of a run hangs.
  Stop last_stop_of(const Node& node, int i) const {
    Stop stop = stop_of(node, i);
    stop.place += run(i).reach();
    return stop;
  }

  // Where a stack beside an end of the run hangs.
  Stop stop_of(const Node& node, int i) const {
    const auto [stack, turns] = stack_and_turns(i);
    Stop stop = state_.hanging[stack].stop();
    const auto is = [&](int j) { return stack_and_turns(j).first == stack; };
    if (collapse_ && stack < state_.top && (stack < node.first || stack >= node.last)) {
      if (is(node.first - 1))
        stop = node.beside_first;
      else if (is(node.last))
        stop = node.beside_last;
      else
        stop = stack < node.first ? node.outermost_first : node.outermost_last;
    }
    if (!collapse_ && node.last > node.first) {
      if (is(node.first))
        stop = node.beside_first;
      else if (is(node.last - 1))
        stop = node.beside_last;
    }
    stop.side += 2 * turns;
    return stop;
  }

  // Only the pairs at the ends of the run hang on both beds.
  bool may_rack(const Node& node, int racking) const {
    if (!collapse_ && node.first == node.last) return true;
    for (const int i : {node.first - 1, node.last - 1}) {
      const Stop a = last_stop_of(node, i), b = stop_of(node, i + 1);
      if (std::abs(position(a, racking) - position(b, racking)) > stack(i).slack) return false;
      if (!in_order(a, b, racking)) return false;
    }
    return true;
  }

  bool one_goal(int i, int j) const {
    const int turns = stack_and_turns(j).second - stack_and_turns(i).second;
    return stack(i).goal_side == stack(j).goal_side + 2 * turns &&
           stack(i).goal == stack(j).goal;
  }

  bool done(const Node& node) const {
    if (collapse_) return node.first == node.last;
    return node.last > node.first && node.first <= state_.top && node.last >= count_;
  }

  // The way beyond the least of the stacks at the ends that might have gone round them.
  long left_behind(const Node& node) const {
    long sum = 0;
    for (int i = node.last - count_; i < node.first && !collapse_; ++i)
      sum += run(i).size() * (remaining_way(state_.tube, stack(i), run(i).stop()) -
                              least_[stack_and_turns(i).first]);
    return sum;
  }

  void list_targets(int i) {
    const Stack& own = stack(i);
    const Stop here = run(i).stop();
    // Loops of the collapsed bed that hang on its hooks again leave them only to go round an end.
    const bool may_park = collapse_ || here.parked, may_stay = !may_park;
    std::optional<long> least;
    if (may_stay) least = remaining_way(state_.tube, own, here);
    std::vector<Target> targets;
    const int most = state_.tube.max_racking;
    for (int racking = -most; racking <= most; ++racking) {
      const Pass pass{from_, racking};
      Stop there = here;
      there.place += shift_of(pass);
      const auto [low, high] = std::minmax({there.place, there.place + run(i).reach()});
      if (low < state_.tube.lowest || high > state_.tube.highest) continue;
      if (changes_side(pass)) {
        if (here.parked || own.roll() == 0) continue;
        there.side += own.roll() > 0 ? 1 : -1;
      } else {
        if (!may_park) continue;
        there.parked = !here.parked;
      }
      const long way = remaining_way(state_.tube, own, there);
      least = least ? std::min(*least, way) : way;
      targets.push_back({pass, there, way});
    }
    targets_.push_back(std::move(targets));
    least_.push_back(least.value_or(0));
  }

  void follow(const Node& node, int at) {
    // Any racking may follow an expansion, so the slack must have room both ways.
    if (done(node) && (collapse_ || may_rack(node, 0))) {
      Node end = node;
      end.closed = true;
      end.before = at;
      end.mover = -1;
      end.cost.first += left_behind(node);
      add(end);
    }
    const int size = node.last - node.first;
    if (collapse_ && size == 0) return;
    if (!collapse_ && size == count_) return;
    move(node, at, collapse_ ? node.first : node.last, true);
    if (collapse_ || size > 0)
      move(node, at, collapse_ ? node.last - 1 : node.first - 1, false);
  }

  // `onwards`: in the list the stack comes after the one that went before it, else ahead of it.
  void move(const Node& node, int at, int i, bool onwards) {
    const auto [mover, turns] = stack_and_turns(i);
    for (const auto& [pass, target, way] : targets_[mover]) {
      if (!may_rack(node, pass.racking)) continue;
      Stop here = target;
      here.side += 2 * turns;
      if (count_ > 1) {
        const Stop left = last_stop_of(node, i - 1), right = stop_of(node, i + 1);
        Stop end = here;
        end.place += run(i).reach();
        if (!in_order(left, here, pass.racking) || !in_order(end, right, pass.racking))
          continue;
        // A stack comes down on an earlier one only.
        if (one_needle(left, here) && !one_goal(i - 1, i)) continue;
        if (one_needle(end, right)) continue;
      }
      Node next = moved(node, i, onwards, target);
      next.before = at;
      next.mover = mover;
      next.target = target;
      next.cost.first += run(i).size() * (way - least_[mover]);
      const bool same_pass =
          node.pass && node.pass->from == pass.from && node.pass->racking == pass.racking;
      next.cost.second += same_pass ? 0 : 1;
      next.pass = pass;
      add(next);
    }
  }

  Node moved(const Node& node, int i, bool onwards, const Stop& target) const {
    Node next = node;
    const bool only = !collapse_ && node.first == node.last;
    if (onwards == collapse_)
      next.first = collapse_ ? i + 1 : i;
    else
      next.last = collapse_ ? i : i + 1;
    if (onwards == collapse_ || only) next.beside_first = target;
    if (onwards != collapse_ || only) next.beside_last = target;
    if (collapse_ && i == 0) next.outermost_first = target;
    if (collapse_ && i + 1 == state_.top) next.outermost_last = target;
    return next;
  }

  const CollapsingTube& state_;
  int count_;
  bool collapse_;
  Bed from_;
  std::vector<std::vector<Target>> targets_;  // of each stack
  std::vector<long> least_;                   // the way that the best of them leaves
  std::vector<Node> nodes_;
  std::map<Key, Cost> best_;
  using Open = std::pair<Cost, int>;
  std::priority_queue<Open, std::vector<Open>, std::greater<Open>> open_;  // ties: oldest first
  int goal_ = -1;
};

}  // namespace

bool cross(CollapsingTube& state, Crossing crossing) {
  const CrossingSearch search(state, crossing);
  if (!search.found()) return false;
  search.apply(state);
  return true;
}

}  // namespace meshknit
