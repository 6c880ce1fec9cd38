#include "meshknit/machine/carriage_passes.h"

#include <algorithm>
#include <cmath>
#include <cstdlib>
#include <optional>
#include <utility>

namespace meshknit {
namespace {

// What operations of one pass have in common.
enum class PassKind { yarn, front_to_back, back_to_front };

struct Pass {
  PassKind kind = PassKind::yarn;
  std::vector<std::string> carriers;
  bool splits = false;         // splits hand loops over: a kind of their own
  bool sliders = false;        // so do moves to and from sliders
  std::optional<Side> travel;  // none while a carrierless pass has one needle only
  int last = 0;                // position reached
  Bed last_bed = Bed::front;
  int lowest = 0, highest = 0;
};

bool is_needle_operation(Op op) {
  switch (op) {
    case Op::knit:
    case Op::tuck:
    case Op::split:
    case Op::drop:
    case Op::amiss:
    case Op::xfer:
    case Op::miss:
      return true;
    default:
      return false;
  }
}

bool is_transfer(const Instruction& i) {
  return i.op == Op::xfer || (i.op == Op::split && i.carriers.empty());
}

class PassCounter {
 public:
  explicit PassCounter(const MachineProfile& profile) : profile_(profile) {}

  void work(const Instruction& i) {
    Pass next = single(i);
    if (open_ && joins(pass_, next)) {
      extend(next);
    } else {
      finish();
      pass_ = std::move(next);
      open_ = true;
    }
  }

  void rack(double racking) {
    if (racking == racking_) return;
    finish();
    racking_ = racking;
    cost_.max_racking = std::max(cost_.max_racking, std::abs(racking));
  }

  // An empty pass in the direction of first stitches; the carriage must come back for it first
  // if it went that way already.
  void release() {
    finish();
    const Side way = profile_.first_stitch_leftward ? Side::left : Side::right;
    cost_.passes += last_travel_ == way ? 2 : 1;
    last_travel_ = way;
  }

  void take_out() {
    finish();
    ++cost_.passes;
    last_travel_.reset();
  }

  void finish() {
    if (!open_) return;
    ++cost_.passes;
    travelled_ += static_cast<long>(pass_.highest) - pass_.lowest + 1;
    last_travel_ = pass_.travel;
    open_ = false;
  }

  ProgramCost cost() {
    finish();
    const double seconds = cost_.passes * profile_.seconds_per_turn +
                           static_cast<double>(travelled_) / profile_.needles_per_second;
    cost_.estimated_minutes = seconds / 60.0;
    return cost_;
  }

  void count(const Instruction& i) {
    if (cost_.operations++ == 0) {
      cost_.lowest_needle = cost_.highest_needle = i.needle.index;
    }
    see(i.needle);
    if (i.op == Op::xfer || i.op == Op::split) see(i.target);
    if (is_transfer(i)) ++cost_.transfers;
  }

 private:
  void see(const Needle& needle) {
    cost_.lowest_needle = std::min(cost_.lowest_needle, needle.index);
    cost_.highest_needle = std::max(cost_.highest_needle, needle.index);
  }

  int position(const Needle& needle) const {
    return needle.index +
           (needle.bed == Bed::back ? static_cast<int>(std::floor(racking_)) : 0);
  }

  Pass single(const Instruction& i) const {
    Pass p;
    if (i.op == Op::xfer || i.op == Op::split) {
      p.kind = i.needle.bed == Bed::front ? PassKind::front_to_back : PassKind::back_to_front;
      p.splits = !is_transfer(i);
      p.sliders = i.needle.slider || i.target.slider;
    }
    p.carriers = i.carriers;
    if (!i.carriers.empty()) p.travel = i.direction;
    p.last = p.lowest = p.highest = position(i.needle);
    p.last_bed = i.needle.bed;
    return p;
  }

  bool joins(const Pass& pass, const Pass& next) const {
    if (pass.kind != next.kind || pass.splits != next.splits || pass.sliders != next.sliders ||
        pass.carriers != next.carriers) {
      return false;
    }
    if (!next.carriers.empty() && pass.travel != next.travel) return false;
    if (next.kind != PassKind::yarn && !next.splits) return true;  // transfers: any order
    if (next.last == pass.last) {
      // Both beds can work at one position only when the beds stand a quarter pitch apart.
      return std::floor(racking_) != racking_ && pass.last_bed == Bed::front &&
             next.last_bed == Bed::back;
    }
    const Side step = next.last > pass.last ? Side::right : Side::left;
    return !pass.travel || pass.travel == step;
  }

  void extend(const Pass& next) {
    if (!pass_.travel && next.kind == PassKind::yarn && next.last != pass_.last) {
      pass_.travel = next.last > pass_.last ? Side::right : Side::left;
    }
    pass_.last = next.last;
    pass_.last_bed = next.last_bed;
    pass_.lowest = std::min(pass_.lowest, next.lowest);
    pass_.highest = std::max(pass_.highest, next.highest);
  }

  const MachineProfile& profile_;
  ProgramCost cost_;
  Pass pass_;
  bool open_ = false;  // pass_ is being made
  std::optional<Side> last_travel_;
  double racking_ = 0.0;
  long travelled_ = 0;
};

}  // namespace

ProgramCost measure_program(const Program& program, const MachineProfile& profile) {
  PassCounter counter(profile);
  for (const Instruction& i : program.instructions) {
    if (is_needle_operation(i.op)) {
      counter.count(i);
      counter.work(i);
      continue;
    }
    switch (i.op) {
      case Op::rack:
        counter.rack(i.racking);
        break;
      case Op::releasehook:
        counter.release();
        break;
      case Op::out:
      case Op::outhook:
        counter.take_out();
        break;
      default:  // in, inhook, pause, extensions (speed, stitch size): the next pass is a new
                // one
        counter.finish();
        break;
    }
  }
  return counter.cost();
}

}  // namespace meshknit
