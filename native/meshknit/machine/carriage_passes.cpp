#include "meshknit/machine/carriage_passes.h"

#include <algorithm>
#include <cmath>
#include <utility>

namespace meshknit {
namespace {

using Kind = CarriagePass::Kind;

// What the cams of a bed do in a pass: a miss leaves all to the others.
enum class Cams { idle, knit, tuck };

Cams cams_of(Op op) {
  if (op == Op::miss) return Cams::idle;
  return op == Op::tuck || op == Op::amiss ? Cams::tuck : Cams::knit;
}

/// A pass while operations join it.
struct OpenPass {
  CarriagePass pass;
  bool splits = false;   // splits hand loops over: a kind of their own
  bool sliders = false;  // so do moves to and from sliders
  int last = 0;          // position reached
  Bed last_bed = Bed::front;
  Cams front = Cams::idle, back = Cams::idle;

  Cams& cams(Bed bed) { return bed == Bed::front ? front : back; }
};

class PassFormer {
 public:
  PassFormer(const Program& program, const MachineProfile& profile)
      : program_(program), profile_(profile) {}

  std::vector<CarriagePass> run() {
    for (int i = 0; i < static_cast<int>(program_.instructions.size()); ++i) {
      const Instruction& instruction = program_.instructions[i];
      if (is_needle_operation(instruction.op)) {
        work(i);
        continue;
      }
      switch (instruction.op) {
        case Op::rack:
          rack(instruction.racking);
          break;
        case Op::releasehook:
          release(i);
          break;
        case Op::out:
        case Op::outhook:
          take_out(i);
          break;
        default:  // in, inhook, pause, extensions (speed, stitch size): the next pass is new
          finish();
          break;
      }
    }
    finish();
    return std::move(passes_);
  }

 private:
  void work(int i) {
    OpenPass next = single(i);
    if (open_ && joins(now_, next)) {
      extend(next);
    } else {
      finish();
      now_ = std::move(next);
      open_ = true;
    }
  }

  void rack(double racking) {
    if (racking == racking_) return;
    finish();
    racking_ = racking;
  }

  // An empty pass in the direction of first stitches; the carriage must come back for it first
  // if it went that way already.
  void release(int i) {
    finish();
    const Side way = profile_.first_stitch_leftward ? Side::left : Side::right;
    const bool went = !passes_.empty() && passes_.back().travel == way;
    if (went) empty_pass(Kind::release, {}, way == Side::left ? Side::right : Side::left);
    empty_pass(Kind::release, {i}, way);
  }

  void take_out(int i) {
    finish();
    empty_pass(Kind::carry_out, {i}, {});
  }

  void empty_pass(Kind kind, std::vector<int> instructions, std::optional<Side> travel) {
    CarriagePass pass;
    pass.kind = kind;
    pass.travel = travel;
    pass.racking = racking_;
    if (!instructions.empty()) pass.carriers = program_.instructions[instructions[0]].carriers;
    pass.instructions = std::move(instructions);
    passes_.push_back(std::move(pass));
  }

  void finish() {
    if (!open_) return;
    open_ = false;
    const bool hands_over = now_.pass.kind != Kind::yarn && !now_.splits;
    if (hands_over && profile_.transfers_in_halves && now_.pass.instructions.size() > 1)
      return add_halves(now_.pass);
    passes_.push_back(std::move(now_.pass));
  }

  // Every second loop from the left, then the rest.
  void add_halves(const CarriagePass& whole) {
    std::vector<std::pair<int, int>> by_place;
    for (const int i : whole.instructions)
      by_place.emplace_back(position(program_.instructions[i].needle), i);
    std::sort(by_place.begin(), by_place.end());
    for (const std::size_t begin : {0, 1}) {
      CarriagePass half = whole;
      half.instructions.clear();
      half.lowest = by_place[begin].first;
      for (std::size_t k = begin; k < by_place.size(); k += 2) {
        half.instructions.push_back(by_place[k].second);
        half.highest = by_place[k].first;
      }
      std::sort(half.instructions.begin(), half.instructions.end());
      passes_.push_back(std::move(half));
    }
  }

  int position(const Needle& needle) const {
    return needle.index +
           (needle.bed == Bed::back ? static_cast<int>(std::floor(racking_)) : 0);
  }

  OpenPass single(int index) const {
    const Instruction& i = program_.instructions[index];
    OpenPass p;
    if (i.op == Op::xfer || i.op == Op::split) {
      p.pass.kind = i.needle.bed == Bed::front ? Kind::front_to_back : Kind::back_to_front;
      p.splits = !i.carriers.empty();
      p.sliders = i.needle.slider || i.target.slider;
    } else {
      p.cams(i.needle.bed) = cams_of(i.op);
    }
    p.pass.carriers = i.carriers;
    p.pass.racking = racking_;
    p.pass.instructions = {index};
    if (!i.carriers.empty()) p.pass.travel = i.direction;
    p.last = p.pass.lowest = p.pass.highest = position(i.needle);
    p.last_bed = i.needle.bed;
    return p;
  }

  bool share_cams(Cams now, Cams next) const {
    return profile_.tucks_beside_knits || now == Cams::idle || next == Cams::idle ||
           now == next;
  }

  bool joins(const OpenPass& now, const OpenPass& next) const {
    if (now.pass.kind != next.pass.kind || now.splits != next.splits ||
        now.sliders != next.sliders || now.pass.carriers != next.pass.carriers ||
        !share_cams(now.front, next.front) || !share_cams(now.back, next.back)) {
      return false;
    }
    if (!next.pass.carriers.empty() && now.pass.travel != next.pass.travel) return false;
    if (next.pass.kind != Kind::yarn && !next.splits) return true;  // transfers: any order
    if (next.last == now.last) {
      // Both beds can work at one position only when the beds stand a fraction apart.
      return std::floor(racking_) != racking_ && now.last_bed == Bed::front &&
             next.last_bed == Bed::back;
    }
    const Side step = next.last > now.last ? Side::right : Side::left;
    return !now.pass.travel || now.pass.travel == step;
  }

  void extend(const OpenPass& next) {
    CarriagePass& pass = now_.pass;
    if (!pass.travel && pass.kind == Kind::yarn && next.last != now_.last)
      pass.travel = next.last > now_.last ? Side::right : Side::left;
    now_.last = next.last;
    now_.last_bed = next.last_bed;
    if (next.front != Cams::idle) now_.front = next.front;
    if (next.back != Cams::idle) now_.back = next.back;
    pass.lowest = std::min(pass.lowest, next.pass.lowest);
    pass.highest = std::max(pass.highest, next.pass.highest);
    pass.instructions.push_back(next.pass.instructions.front());
  }

  const Program& program_;
  const MachineProfile& profile_;
  std::vector<CarriagePass> passes_;
  OpenPass now_;
  bool open_ = false;  // now_ is being made
  double racking_ = 0.0;
};

}  // namespace

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

std::vector<CarriagePass> carriage_passes(const Program& program,
                                          const MachineProfile& profile) {
  return PassFormer(program, profile).run();
}

}  // namespace meshknit
