#include "transfer/exact_search.h"

#include <cstdlib>
#include <map>
#include <set>

namespace meshknit {
namespace {

// Places of all loops. Stacks need no order of their own: a merge in the wrong order is not
// made.
using State = std::vector<Place>;

class Search {
 public:
  Search(const TransferProblem& problem, int limit) : problem_(problem) {
    State start, goal;
    for (const TransferLoop& loop : problem.loops) {
      start.push_back({loop.from_bed, loop.from, false});
      goal.push_back({loop.to_bed, loop.to, false});
    }
    std::set<State> seen{start};
    std::vector<State> front{start};
    for (; passes < limit && seen.count(goal) == 0; ++passes) {
      std::vector<State> next;
      for (const State& state : front)
        for (int racking = -problem.max_racking; racking <= problem.max_racking; ++racking)
          if (holds(state, racking))
            for (const Bed bed : {Bed::front, Bed::back})
              for (State& after : one_pass(state, bed, racking))
                if (passes + 1 + passes_left(after) < limit && seen.insert(after).second)
                  next.push_back(std::move(after));
      front = std::move(next);
    }
  }
  int passes = 0;

 private:
  int size() const { return static_cast<int>(problem_.loops.size()); }

  // At least so many passes are still to come: one for each direction that some loop must take.
  int passes_left(const State& state) const {
    bool needed[2] = {false, false};  // from the front bed, from the back bed
    for (int i = 0; i < size(); ++i) {
      const TransferLoop& loop = problem_.loops[i];
      if (state[i] == Place{loop.to_bed, loop.to, false}) continue;
      const bool on_goal_bed = state[i].bed == loop.to_bed;
      needed[state[i].bed == Bed::back] = true;
      if (on_goal_bed) needed[state[i].bed == Bed::front] = true;  // there and back
    }
    return needed[0] + needed[1];
  }

  static int position(const Place& place, int racking) {
    const Needle needle = half_gauge_needle(place);
    return needle.index + (needle.bed == Bed::back ? racking : 0);
  }
  static int key(const Place& place, int racking) {  // rises anticlockwise
    const bool front_side = (place.bed == Bed::front) != place.parked;
    return front_side ? position(place, racking) : 1000 - position(place, racking);
  }

  bool in_order(const State& state, int racking) const {
    int descents = 0;
    for (int i = 0; i < size(); ++i)
      descents += key(state[i], racking) > key(state[(i + 1) % size()], racking);
    return descents <= 1;
  }
  bool holds(const State& state, int racking) const {
    for (int i = 0; i < size(); ++i) {
      const int other = position(state[(i + 1) % size()], racking);
      if (std::abs(position(state[i], racking) - other) > problem_.slack[i]) return false;
    }
    return in_order(state, racking);
  }

  bool same_goal(int i, int j) const {
    return problem_.loops[i].to_bed == problem_.loops[j].to_bed &&
           problem_.loops[i].to == problem_.loops[j].to;
  }
  // True if i comes before j, walking round from the first loop of their common goal.
  bool below(int i, int j) const {
    int start = i;
    for (int k = 0; k < size() && same_goal((start + size() - 1) % size(), i); ++k)
      start = (start + size() - 1) % size();
    return (i - start + size()) % size() < (j - start + size()) % size();
  }

  std::vector<State> one_pass(const State& state, Bed bed, int racking) const {
    std::map<int, std::vector<int>> stacks;  // by needle of `bed`
    for (int i = 0; i < size(); ++i)
      if (state[i].bed == bed) stacks[half_gauge_needle(state[i]).index].push_back(i);
    std::vector<State> found{state};
    for (const auto& [needle, loops] : stacks) {
      const Place from = state[loops.front()];
      const int to = bed == Bed::front ? needle - racking : needle + racking;
      const bool odd = to % 2 != 0;
      Place target{opposite(bed), (to - (odd ? 1 : 0)) / 2, false};
      target.parked = odd == (target.bed == Bed::front);
      if (from.parked && target.parked) continue;
      if (target.n < problem_.lowest || target.n > problem_.highest) continue;
      bool allowed = true;
      for (int j = 0; j < size() && allowed; ++j)
        for (const int i : loops)
          if (state[j] == target && (!same_goal(i, j) || !below(j, i))) allowed = false;
      if (!allowed) continue;
      const std::size_t count = found.size();
      for (std::size_t f = 0; f < count; ++f) {
        found.push_back(found[f]);
        for (const int i : loops) found.back()[i] = target;
      }
    }
    std::vector<State> good;
    for (State& after : found)
      if (in_order(after, racking)) good.push_back(std::move(after));
    return good;
  }

  const TransferProblem& problem_;
};

}  // namespace

int fewest_passes(const TransferProblem& problem, int limit) {
  return Search(problem, limit).passes;
}

}  // namespace meshknit
