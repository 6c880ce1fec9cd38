#include "meshknit/transfer/transfer_checks.h"

#include <cstdlib>
#include <map>
#include <string>
#include <utility>

namespace meshknit {
namespace {

std::string name(const Place& place) { return to_string(half_gauge_needle(place)); }

// The replayed tube: where each loop hangs, and what each needle holds from below to above.
class Replay {
 public:
  explicit Replay(const TransferProblem& problem)
      : problem_(problem), rank_(problem.loops.size()) {
    for (const TransferLoop& loop : problem.loops) {
      stacks_[half_gauge_needle({loop.from_bed, loop.from, false})].push_back(count());
      places_.push_back({loop.from_bed, loop.from, false});
    }
    rank_groups();
  }

  // Both return an empty code if all is well.
  Problem rack_to(int racking);
  Problem move(const Transfer& transfer);
  Problem arrived() const;

  int racking() const { return racking_; }

 private:
  int count() const { return static_cast<int>(places_.size()); }
  int next(int i) const { return i + 1 == count() ? 0 : i + 1; }
  int previous(int i) const { return i == 0 ? count() - 1 : i - 1; }
  bool same_target(int i, int j) const {
    const TransferLoop &a = problem_.loops[i], &b = problem_.loops[j];
    return a.to_bed == b.to_bed && a.to == b.to;
  }

  // Where a loop is across the machine, in front needles.
  int position(int i) const {
    const Needle needle = half_gauge_needle(places_[i]);
    return needle.bed == Bed::back ? needle.index + racking_ : needle.index;
  }
  // The side of the tube a loop belongs to; parked loops hang on the other bed.
  Bed side(int i) const {
    return places_[i].parked ? opposite(places_[i].bed) : places_[i].bed;
  }

  // True where the walk round the tube steps back. A tube in order does so once, at its seam.
  bool steps_back(int i) const {
    const int j = next(i);
    if (side(i) != side(j)) return side(i) == Bed::back;
    return side(i) == Bed::front ? position(i) > position(j) : position(i) < position(j);
  }
  int count_steps_back() const {
    int steps = 0;
    for (int i = 0; i < count(); ++i) steps += steps_back(i);
    return steps;
  }
  // Steps back at the pairs that loop i belongs to.
  int steps_back_around(int i) const {
    return steps_back(i) + (count() > 1 ? steps_back(previous(i)) : 0);
  }

  void rank_groups();
  Problem problem_with(std::string code, std::string message, std::vector<int> loops) const;

  const TransferProblem& problem_;
  std::vector<Place> places_;
  std::vector<int> rank_;  // position of a loop among those with its target, 0 = lowest
  std::map<Needle, std::vector<int>> stacks_;
  int racking_ = 0;
  int steps_back_ = 0;
};

void Replay::rank_groups() {
  int start = 0;
  while (start < count() && same_target(previous(start), start)) ++start;
  if (start == count()) start = 0;
  for (int k = 0; k < count(); ++k) {
    const int i = (start + k) % count();
    rank_[i] = k > 0 && same_target(previous(i), i) ? rank_[previous(i)] + 1 : 0;
  }
}

Problem Replay::problem_with(std::string code, std::string message,
                             std::vector<int> loops) const {
  Problem problem;
  problem.code = std::move(code);
  problem.message = std::move(message);
  problem.remedy = "Please report this: the planned transfers would spoil the tube.";
  problem.elements.stitches = std::move(loops);
  return problem;
}

Problem Replay::rack_to(int racking) {
  racking_ = racking;
  if (std::abs(racking) > problem_.max_racking)
    return problem_with("racking-limit",
                        "A transfer needs racking " + std::to_string(racking) +
                            "; the limit is " + std::to_string(problem_.max_racking) + ".",
                        {});
  for (int i = 0; i < count(); ++i) {
    const int distance = std::abs(position(i) - position(next(i)));
    if (distance > problem_.slack[i])
      return problem_with("slack-exceeded",
                          "At racking " + std::to_string(racking) + " the loops on " +
                              name(places_[i]) + " and " + name(places_[next(i)]) + " are " +
                              std::to_string(distance) + " needles apart; their yarn reaches " +
                              std::to_string(problem_.slack[i]) + ".",
                          {i, next(i)});
  }
  steps_back_ = count_steps_back();
  if (steps_back_ > 1)
    return problem_with("order-lost",
                        "At racking " + std::to_string(racking) +
                            " a parked loop lies beyond a neighbour that stayed.",
                        {});
  return {};
}

Problem Replay::move(const Transfer& transfer) {
  const std::string step = "from " + name(transfer.from) + " to " + name(transfer.to);
  if (transfer.from.bed == transfer.to.bed)
    return problem_with("same-bed-transfer", "The transfer " + step + " stays on one bed.", {});
  if (transfer.to.n < problem_.lowest || transfer.to.n > problem_.highest)
    return problem_with("place-out-of-range",
                        "The transfer " + step + " leaves the needles of this tube.", {});
  const auto source = stacks_.find(half_gauge_needle(transfer.from));
  if (source == stacks_.end())
    return problem_with("transfer-from-empty", "The transfer " + step + " finds no loop.", {});
  const std::vector<int> moved = source->second;
  if (transfer.from.parked && transfer.to.parked)
    return problem_with(
        "parked-to-parked",
        "The transfer " + step + " takes a parked loop to the other side of the tube.", moved);

  stacks_.erase(source);
  std::vector<int>& target = stacks_[half_gauge_needle(transfer.to)];
  for (const int i : moved) {
    if (!target.empty() && !same_target(target.back(), i))
      return problem_with(
          "stranger-stacked",
          "The transfer " + step + " stacks loops that are not decreased together.",
          {target.back(), i});
    if (!target.empty() && rank_[target.back()] > rank_[i])
      return problem_with(
          "stack-order",
          "The transfer " + step + " stacks the loops of a decrease in the wrong order.",
          {target.back(), i});
    target.push_back(i);
  }
  // A stack that goes round an end passes through states in which only some of its loops have
  // moved, so order is asked once all of them hang on the new needle.
  for (const int i : moved) {
    steps_back_ -= steps_back_around(i);
    places_[i] = transfer.to;
    steps_back_ += steps_back_around(i);
  }
  if (steps_back_ > 1)
    return problem_with("order-lost",
                        "The transfer " + step + " takes a loop past its neighbour.", moved);
  return {};
}

Problem Replay::arrived() const {
  for (int i = 0; i < count(); ++i) {
    const Place target{problem_.loops[i].to_bed, problem_.loops[i].to, false};
    if (places_[i] != target)
      return problem_with(
          "not-arrived",
          "A loop hangs on " + name(places_[i]) + " instead of " + name(target) + ".", {i});
  }
  return {};
}

}  // namespace

Problems check_transfer_plan(const TransferProblem& problem, const TransferPlan& plan) {
  Replay replay(problem);
  Problem found = replay.rack_to(0);
  for (const Transfer& transfer : plan.transfers) {
    if (!found.code.empty()) break;
    if (transfer.from.bed != transfer.to.bed && racking_of(transfer) != replay.racking())
      found = replay.rack_to(racking_of(transfer));
    if (found.code.empty()) found = replay.move(transfer);
  }
  if (found.code.empty()) found = replay.rack_to(0);
  if (found.code.empty()) found = replay.arrived();
  return found.code.empty() ? Problems{} : Problems{found};
}

}  // namespace meshknit
