#include "meshknit/verify/tube_check.h"

#include <string>
#include <utility>

#include "meshknit/verify/beds.h"
#include "meshknit/verify/cast_ons.h"
#include "meshknit/verify/junction_queue.h"
#include "meshknit/verify/tube_places.h"
#include "meshknit/verify/tubes.h"
#include "meshknit/verify/yarn_paths.h"

namespace meshknit {
namespace {

class TubeCheck {
 public:
  TubeCheck(const Program& program, const MachineProfile& profile, const Fabric& fabric,
            const StitchTrace& trace, const std::vector<ExpectedLoop>& items, ProblemLog& log)
      : fabric_(fabric),
        trace_(trace),
        items_(items),
        log_(log),
        plan_(find_trace_columns(trace)),
        queue_(plan_.junctions),
        cast_ons_(fabric, items, plan_),
        beds_(program, profile, -1),
        places_(tubes_, log),
        paths_(fabric, tubes_, log),
        column_of_(fabric.loops.size(), -1),
        column_at_(static_cast<std::size_t>(plan_.columns), -1) {}

  void run(const Instruction& i) {
    switch (i.op) {
      case Op::knit:
      case Op::tuck:
        return make_loop(i);
      case Op::split:
        hand_over(i);
        return make_loop(i);
      case Op::xfer:
        return hand_over(i);
      case Op::drop:
        return drop(i);
      default:
        return;
    }
  }

 private:
  ExpectedLoop item(int loop) const { return items_.empty() ? ExpectedLoop{} : items_[loop]; }

  void make_loop(const Instruction& i) {
    const bool replayed = next_loop_ < static_cast<int>(fabric_.loops.size()) &&
                          fabric_.loops[next_loop_].line == i.line;
    if (!replayed) return;
    const int id = next_loop_++;
    if (i.source.kind == Source::Kind::anchor) return;
    const ExpectedLoop made = item(id);
    if (made.stitch >= 0) {
      const int due = queue_.due(made.stitch);
      if (due >= 0) happen(due, i.line);
    }
    int& column = beds_.at(i.needle);
    const auto tube = [&] {
      return column >= 0 ? tubes_.tube_of(column) : cast_ons_.tube(id, tubes_, column_of_);
    };
    while (parts_before_rest(tube())) happen(open_junction(tube(), -1), i.line);
    if (tube() >= 0) check_rest(tube(), i);
    places_.check(i.line);
    if (column < 0) column = hang_new(id, tube(), i);
    cast_ons_.made(id, column);
    column_of_[id] = column;
    newest_[column] = id;
    check_step(id);
    paths_.made(id, column_of_);
    if (made.stitch < 0) return;
    const int traced = plan_.of[made.stitch][made.which];
    if (traced >= 0) column_at_[traced] = column;
    queue_.made(made.stitch);
  }

  int hang_new(int id, int tube, const Instruction& i) {
    const int column = tube >= 0 ? tubes_.insert(tube, i.needle) : tubes_.begin(i.needle);
    newest_.push_back(id);
    const int now = tubes_.tube_of(column);
    places_.touched(now);
    for (const int other : std::vector<int>(tubes_.held_tubes())) {
      if (other == now || !tubes_.crosses(column, other)) continue;
      log_.error(
          "tubes-interleaved", i.line,
          "the loop on " + to_string(i.needle) + " is made between loops of another tube",
          {named_stitch(fabric_.loops[id])});
    }
    return column;
  }

  bool parts_before_rest(int tube) const {
    return tube >= 0 && !tubes_.order(tube).at_rest() && open_junction(tube, -1) >= 0;
  }

  // Stitches are made while the tube lies flat, with no loop parked or out of turn.
  void check_rest(int tube, const Instruction& i) {
    if (tube >= static_cast<int>(unrest_named_.size())) unrest_named_.resize(tube + 1, false);
    if (tubes_.order(tube).at_rest()) {
      unrest_named_[tube] = false;
    } else if (!unrest_named_[tube]) {
      unrest_named_[tube] = true;
      const int stitch = i.source.kind == Source::Kind::stitch ? i.source.stitch : -1;
      log_.error("tube-order", i.line,
                 "a stitch is made on " + to_string(i.needle) +
                     " while the loops on the beds are not in the order of the tube",
                 {stitch});
    }
  }

  // An increase's second loop hangs beside its first, ahead of it; starts follow one another
  // round the waste without leaving a loop out.
  void check_step(int id) {
    const ExpectedLoop made = item(id);
    if (made.stitch < 0) return;
    const Stitch& stitch = trace_.stitches[made.stitch];
    const bool second = made.which == 1;
    if (!second && stitch.kind != StitchKind::start) return;
    const int previous = fabric_.loops[id].previous;
    const int from = previous >= 0 ? column_of_[previous] : -1;
    bool beside = false;
    if (from >= 0 && tubes_.is_held(from) && from != column_of_[id]) {
      beside = stitch.direction == Direction::clockwise
                   ? tubes_.previous(from) == column_of_[id]
                   : tubes_.next(from) == column_of_[id];
    }
    if (second && !beside) {
      return wrong(id, "increase-not-beside",
                   "makes its second loop elsewhere than right ahead of its first");
    }
    if (second || previous < 0 || beside) return;
    const int before = item(previous).stitch;
    if (before < 0) return;
    const Stitch& last = trace_.stitches[before];
    if (last.kind == StitchKind::start && last.direction == stitch.direction) {
      wrong(id, "start-leaves-gap", "does not begin beside the start before it");
    }
  }

  void wrong(int id, const std::string& code, const std::string& what) {
    const int stitch = items_[id].stitch;
    log_.error(code, fabric_.loops[id].line, "stitch " + std::to_string(stitch) + " " + what,
               {stitch});
  }

  void hand_over(const Instruction& i) {
    if (!beds_.has(i.needle) || !beds_.has(i.target) || i.needle == i.target) return;
    const int column = std::exchange(beds_.at(i.needle), -1);
    if (column < 0) return;
    int& there = beds_.at(i.target);
    places_.touched(tubes_.tube_of(column));
    if (there >= 0) {
      const bool neighbours =
          tubes_.tube_of(column) == tubes_.tube_of(there) &&
          (tubes_.next(column) == there || tubes_.previous(column) == there);
      if (!neighbours) {
        log_.error("merge-of-strangers", i.line,
                   "the loops on " + to_string(i.needle) + " and " + to_string(i.target) +
                       " are not neighbours round the tube and cannot share a needle",
                   named(column));
      }
      return tubes_.remove(column);
    }
    there = column;
    move(column, i);
  }

  void move(int column, const Instruction& i) {
    const Bed bed = i.target.bed;
    const int turns = tubes_.order(tubes_.tube_of(column)).turns(bed);
    tubes_.move(column, i.target);
    const auto passed_over = [&] {
      const int now = tubes_.order(tubes_.tube_of(column)).turns(bed);
      return now > 2 && now > turns;
    };
    while (passed_over() && open_junction(tubes_.tube_of(column), -1) >= 0) {
      happen(open_junction(tubes_.tube_of(column), -1), i.line);
    }
    if (passed_over()) {
      log_.error(
          "loop-passes-over", i.line,
          "the loop brought to " + to_string(i.target) + " passed over others of its tube",
          named(column));
    }
    for (const int other : std::vector<int>(tubes_.held_tubes())) {
      const auto crossing = [&] {
        const int tube = tubes_.tube_of(column);
        return other != tube && tubes_.order(other).size() > 0 && tubes_.crosses(column, other);
      };
      while (crossing() && open_junction(tubes_.tube_of(column), other) >= 0) {
        happen(open_junction(tubes_.tube_of(column), other), i.line);
      }
      if (!crossing()) continue;
      log_.error("passes-other-tube", i.line,
                 "the loop brought to " + to_string(i.target) +
                     " came between or past loops of another tube",
                 named(column), "Move the other tube out of the way first.");
    }
  }

  void drop(const Instruction& i) {
    if (!beds_.has(i.needle)) return;
    const int column = std::exchange(beds_.at(i.needle), -1);
    if (column < 0) return;
    places_.touched(tubes_.tube_of(column));
    tubes_.remove(column);
  }

  // The first open junction that parts this tube, or joins it to the other (-1: to none). -1 if
  // there is none.
  int open_junction(int tube, int other) const {
    for (const int j : queue_.open()) {
      const int a = tube_at(plan_.junctions[j].first);
      const int b = tube_at(plan_.junctions[j].second);
      if (other < 0 && a == tube && b == tube) return j;
      if (other >= 0 && ((a == tube && b == other) || (a == other && b == tube))) return j;
    }
    return -1;
  }

  int tube_at(int traced) const {
    const int column = column_at_[traced];
    return column >= 0 ? tubes_.tube_of(column) : -1;
  }

  void happen(int junction, int line) {
    queue_.done(junction);
    const int first = column_at_[plan_.junctions[junction].first];
    const int second = column_at_[plan_.junctions[junction].second];
    const int tube = tube_at(plan_.junctions[junction].first);
    const int other = tube_at(plan_.junctions[junction].second);
    if (tube < 0 || other < 0 || first == second || tubes_.next(first) == second) return;
    const int parted = tubes_.meet(first, second);
    if (parted >= 0) {
      places_.parted(parted, tube);
    } else {
      places_.met(tube, other);
    }
    for (const int made : {tube, parted}) {
      if (made >= 0) check_clear(made, line);
    }
  }

  void check_clear(int tube, int line) {
    for (const int other : tubes_.held_tubes()) {
      if (other == tube || !tubes_.tube_crosses(tube, other)) continue;
      log_.error("tubes-interleaved", line,
                 "where tubes part or meet here, loops of another tube hang in between", {},
                 "Move the other tube out of the way first.");
    }
  }

  std::vector<int> named(int column) const {
    return {named_stitch(fabric_.loops[newest_[column]])};
  }

  const Fabric& fabric_;
  const StitchTrace& trace_;
  const std::vector<ExpectedLoop>& items_;
  ProblemLog& log_;
  const TraceColumns plan_;
  JunctionQueue queue_;
  CastOns cast_ons_;
  Beds<int> beds_;  // column on each needle
  Tubes tubes_;
  TubePlaces places_;
  YarnPaths paths_;
  std::vector<int> column_of_;  // loop -> column
  std::vector<int> newest_;     // column -> loop
  std::vector<int> column_at_;  // traced column -> column
  std::vector<bool> unrest_named_;
  int next_loop_ = 0;
};

}  // namespace

void check_tubes(const Program& program, const MachineProfile& profile, const Fabric& fabric,
                 const StitchTrace& trace, const std::vector<ExpectedLoop>& items,
                 ProblemLog& log, RunContext* run) {
  TubeCheck check(program, profile, fabric, trace, items, log);
  constexpr std::size_t kBetweenReports = 4096;
  for (std::size_t k = 0; k < program.instructions.size(); ++k) {
    if (k % kBetweenReports == 0) {
      report(run, 0.5 + 0.5 * static_cast<double>(k) /
                            static_cast<double>(program.instructions.size()));
    }
    check.run(program.instructions[k]);
  }
}

}  // namespace meshknit
