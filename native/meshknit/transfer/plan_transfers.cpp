#include "meshknit/transfer/plan_transfers.h"

#include <algorithm>
#include <cstdlib>
#include <string>
#include <tuple>
#include <utility>

#include "meshknit/core/error.h"
#include "meshknit/transfer/collapse_shift_expand.h"
#include "meshknit/transfer/pass_search.h"
#include "meshknit/transfer/three_passes.h"
#include "meshknit/transfer/transfer_checks.h"
#include "meshknit/transfer/turning.h"

namespace meshknit {
namespace {

Problem impossible(std::string message, std::string remedy, std::vector<int> loops) {
  Problem problem;
  problem.code = "transfer-impossible";
  problem.message = std::move(message);
  problem.remedy = std::move(remedy);
  problem.elements.stitches = std::move(loops);
  return problem;
}

// Pairs that the layouts before and after already stretch; no plan can help them.
Problems stretched_layouts(const TransferProblem& problem) {
  Problems found;
  const int count = static_cast<int>(problem.loops.size());
  for (int i = 0; i < count; ++i) {
    const int j = (i + 1) % count;
    const TransferLoop &a = problem.loops[i], &b = problem.loops[j];
    const int before = half_gauge_needle({a.from_bed, a.from, false}).index -
                       half_gauge_needle({b.from_bed, b.from, false}).index;
    const int after = half_gauge_needle({a.to_bed, a.to, false}).index -
                      half_gauge_needle({b.to_bed, b.to, false}).index;
    const int distance = std::max(std::abs(before), std::abs(after));
    if (distance > problem.slack[i])
      found.push_back(impossible("Two neighbouring loops must hang " +
                                     std::to_string(distance) +
                                     " needles apart, but their yarn reaches only " +
                                     std::to_string(problem.slack[i]) + ".",
                                 "Make the shape change more slowly here.", {i, j}));
  }
  return found;
}

NotKnittable no_way() {
  return NotKnittable({impossible(
      "The loops of this row cannot be moved to where the next row needs them: the yarn "
      "between "
      "neighbouring loops is too short, or there is no room beside the tube.",
      "Leave more needles free beside the object, or make the shape change more slowly here.",
      {})});
}

// Passes, then racking travel, then transfers.
std::tuple<int, int, std::size_t> cost(const TransferPlan& plan) {
  Passes passes;
  for (const Transfer& transfer : plan.transfers)
    passes.push_back({transfer.from.bed, racking_of(transfer)});
  return {count_passes(plan), racking_travel(passes), plan.transfers.size()};
}

// The way of moving that is tried first; the other one steps in where it is stuck.
enum class Step { whole_tube, few_stacks };

bool step_nearer(Tube& tube, TransferPlan& plan, Step step) {
  if (step == Step::whole_tube && collapse_shift_expand(tube, plan)) return true;
  if (const std::optional<PassPlan> passes = three_passes(tube)) {
    advance(tube, *passes, plan);
    return true;
  }
  return step == Step::few_stacks && collapse_shift_expand(tube, plan);
}

long remaining_way(const Tube& tube) {
  long way = 0;
  for (const Stack& stack : tube.stacks)
    way += remaining_way(tube, stack, {stack.side, stack.place, false});
  return way;
}

class Planner {
 public:
  Planner(const Tube& tube, PairWaysCache& cache) : tube_(tube), cache_(cache) {}

  std::optional<TransferPlan> best;

  // The whole way in one search; false if it finds none of so many passes.
  bool search(int least, int most) {
    const std::optional<PassPlan> way = search_passes(tube_, cache_, least, most);
    if (!way) return false;
    Tube tube = tube_;
    TransferPlan plan;
    advance(tube, *way, plan);
    keep_cheaper(std::move(plan));
    return true;
  }

  // Step by step, and, if asked for, with a search for the rest of the way after each; given up
  // where it gets dearer than the best plan so far, or is about to.
  void plan(Step step, bool search_the_rest) {
    Tube tube = tube_;
    TransferPlan begun;
    const long whole_way = remaining_way(tube);
    while (step_nearer(tube, begun, step)) {
      if (tube.arrived()) return keep_cheaper(std::move(begun));
      const long way_made = whole_way - remaining_way(tube);
      if (best && count_passes(begun) * whole_way > patience * count_passes(*best) * way_made)
        return;
      const int most = best ? count_passes(*best) - count_passes(begun) : most_passes;
      if (most <= 0) return;
      if (!search_the_rest || most > most_passes) continue;
      if (const std::optional<PassPlan> rest = search_passes(tube, cache_, 1, most)) {
        advance(tube, *rest, begun);
        return keep_cheaper(std::move(begun));
      }
    }
  }

 private:
  // At its pace so far a plan may seem this much dearer than the best: a search may find a
  // shorter rest.
  static constexpr int patience = 2;

  void keep_cheaper(TransferPlan plan) {
    if (!best || cost(plan) < cost(*best)) best = std::move(plan);
  }

  const Tube& tube_;
  PairWaysCache& cache_;
};

// Up to so many passes a search takes less time than a collapse, which would bound it.
constexpr int few_passes = 4;

// A search of the whole way finds the fewest passes, where it finds one in time. None of the ways
// of stepping is always better: few stacks make fewer transfers, whole tubes often fewer passes.
// Where whole tubes take many, few stacks at a time take no fewer, and long to plan.
std::optional<TransferPlan> cheapest_plan(const Tube& tube, PairWaysCache& cache) {
  if (tube.arrived()) return TransferPlan{};
  Planner planner(tube, cache);
  if (planner.search(1, few_passes)) return planner.best;
  planner.plan(Step::whole_tube, false);
  const int most = planner.best ? count_passes(*planner.best) : most_passes;
  if (most <= most_passes && planner.search(few_passes + 1, most)) return planner.best;
  planner.plan(Step::whole_tube, true);
  if (!planner.best || count_passes(*planner.best) <= most_passes)
    planner.plan(Step::few_stacks, true);
  return planner.best;
}

// Turns as long as many loops must go round the ends, and then the cheapest plan.
std::optional<TransferPlan> plan_in_turns(Tube tube, PairWaysCache& cache) {
  TransferPlan plan;
  while (const std::optional<PassPlan> turn = turn_by_two(tube, cache))
    advance(tube, *turn, plan);
  const std::optional<TransferPlan> rest = cheapest_plan(tube, cache);
  if (!rest) return std::nullopt;
  plan.transfers.insert(plan.transfers.end(), rest->transfers.begin(), rest->transfers.end());
  return plan;
}

}  // namespace

TransferPlan plan_transfers(const TransferProblem& problem) {
  return TransferPlanner().plan(problem);
}

TransferPlan TransferPlanner::plan(const TransferProblem& problem) {
  if (const Problems wrong = check_transfer_form(problem); !wrong.empty())
    throw InvalidInput(wrong.front().message);

  if (Problems stretched = stretched_layouts(problem); !stretched.empty())
    throw NotKnittable(std::move(stretched));

  const std::optional<TransferPlan> found = plan_in_turns(make_tube(problem), cache_);
  if (!found) throw no_way();
  const TransferPlan& plan = *found;
  if (const Problems broken = check_transfer_plan(problem, plan); !broken.empty())
    throw BrokenPromise("a transfer plan failed its replay: " + broken.front().message);
  return plan;
}

}  // namespace meshknit
