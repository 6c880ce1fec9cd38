#include "meshknit/knitout/kcode_plan.h"

#include <algorithm>
#include <cmath>
#include <cstdlib>
#include <string>
#include <utility>

#include "meshknit/core/error.h"
#include "meshknit/knitout/kcode_settings.h"
#include "meshknit/machine/carriage_passes.h"

namespace meshknit {
namespace {

using Kind = CarriagePass::Kind;

constexpr int kEmptySpeed = 300;  // of sweeps that make no loops

[[noreturn]] void refuse(const std::string& what) {
  throw InvalidInput("a .kc file cannot hold " + what);
}

class Planner {
 public:
  Planner(const Program& program, const MachineProfile& profile)
      : program_(program),
        profile_(profile),
        passes_(carriage_passes(program, profile)),
        at_(profile.carriers.size() + 1, kParkingColumn),
        in_(profile.carriers.size() + 1, false) {
    if (profile.carriers.size() > 9) refuse("more carriers than digits");
    for (const Instruction& i : program.instructions) check(i);
  }

  std::vector<KcodePass> run() {
    for (now_ = 0; now_ < passes_.size(); ++now_) {
      const CarriagePass& pass = passes_[now_];
      follow_settings(pass.instructions.front());
      if (pass.kind == Kind::carry_out) {
        const int carrier = carrier_of(pass);
        move(carrier, kParkingColumn, "carrier " + pass.carriers[0] + " goes out");
        in_[carrier] = false;
        continue;
      }
      sweep(pass);
    }
    turn_at_outermost_stops();
    return std::move(sweeps_);
  }

 private:
  void check(const Instruction& i) const {
    if (i.op == Op::pause) refuse("a pause");
    if (i.op == Op::rack && std::floor(2.0 * i.racking) != 2.0 * i.racking)
      refuse("rackings other than whole and half needles");
    if (i.op == Op::split) refuse("splits");
    if (i.op == Op::inhook || i.op == Op::outhook || i.op == Op::releasehook)
      refuse("an inserting hook");
    if (i.carriers.size() > 1) refuse("several carriers at a time");
    if (!i.carriers.empty() && number_of(i.carriers[0]) == 0)
      refuse("carrier " + i.carriers[0]);
    if (i.needle.slider || i.target.slider) refuse("sliders");
    const bool works = i.op == Op::knit || i.op == Op::tuck || i.op == Op::drop ||
                       i.op == Op::amiss || i.op == Op::xfer || i.op == Op::miss;
    if (works) check(i.needle);
    if (i.op == Op::xfer) check(i.target);
  }

  void check(const Needle& needle) const {
    if (needle.index < 1 || needle.index > profile_.needles)
      refuse("needle " + to_string(needle));
  }

  int number_of(const std::string& carrier) const {
    const auto& all = profile_.carriers;
    const auto found = std::find(all.begin(), all.end(), carrier);
    return found == all.end() ? 0 : static_cast<int>(found - all.begin()) + 1;
  }

  int carrier_of(const CarriagePass& pass) const {
    return pass.carriers.empty() ? 0 : number_of(pass.carriers[0]);
  }

  void follow_settings(int instruction) {
    for (; read_ < instruction; ++read_)
      if (program_.instructions[read_].op == Op::extension)
        settings_.take(program_.instructions[read_].text);
  }

  void sweep(const CarriagePass& pass) {
    const int left = column_of(pass.lowest), right = column_of(pass.highest) + 1;
    const int carrier = carrier_of(pass);
    clear(left, right, carrier);
    if (carrier > 0 && pass.travel == Side::right && at_[carrier] > left)
      move(carrier, stop(left, Side::left, carrier), "carrier to its side");
    if (carrier > 0 && pass.travel == Side::left && at_[carrier] < right)
      move(carrier, stop(right, Side::right, carrier), "carrier to its side");
    face(pass.travel.value_or(next_way()));
    KcodePass work = loops_of(pass);
    work.direction = next_way();
    work.carriage_left = left - kCarrierDistance;
    work.carriage_right = right + kCarrierDistance;
    if (carrier > 0) {
      const bool rightward = work.direction == Side::right;
      const int to =
          rightward ? stop(right, Side::right, carrier) : stop(left, Side::left, carrier);
      carry(work, carrier, to);
      in_[carrier] = true;
    }
    sweeps_.push_back(std::move(work));
  }

  KcodePass loops_of(const CarriagePass& pass) {
    KcodePass work;
    work.racking = pass.racking;
    work.speed = settings_.speed;
    for (const int index : pass.instructions) {
      const Instruction& i = program_.instructions[index];
      const bool front = i.needle.bed == Bed::front;
      if (i.op == Op::miss) continue;
      (front ? work.front : work.rear).push_back(i.needle.index);
      if (i.op == Op::xfer) (front ? work.rear : work.front).push_back(i.target.index);
      if (i.op == Op::tuck || i.op == Op::amiss)
        (front ? work.front_tucks : work.rear_tucks) = true;
    }
    std::sort(work.front.begin(), work.front.end());
    std::sort(work.rear.begin(), work.rear.end());
    work.comment = name_of(pass);
    work.roller = std::exchange(settings_.added_roller, 0);
    if (pass.kind == Kind::yarn) {
      work.roller += settings_.roller;
      if (!work.front.empty()) work.front_size = settings_.stitch;
      if (!work.rear.empty()) work.rear_size = settings_.stitch;
      return work;
    }
    work.kind = pass.kind == Kind::front_to_back ? KcodePass::Kind::front_to_back
                                                 : KcodePass::Kind::back_to_front;
    work.front_size = work.rear_size = settings_.transfer;
    return work;
  }

  std::string name_of(const CarriagePass& pass) const {
    const Instruction& first = program_.instructions[pass.instructions.front()];
    const Instruction& last = program_.instructions[pass.instructions.back()];
    if (first.op == Op::xfer) return "transfers";
    if (first.op == Op::drop) return "drops";
    switch (first.source.kind) {
      case Source::Kind::stitch:
        return "stitches " + std::to_string(first.source.stitch) + " to " +
               std::to_string(last.source.stitch);
      case Source::Kind::waste:
        return "waste";
      case Source::Kind::anchor:
        return "anchors";
      case Source::Kind::none:
        break;
    }
    return "no loops of the object";
  }

  // Waiting carriers leave the needles at work, to the side from which they are wanted next.
  void clear(int left, int right, int own) {
    for (int carrier = 1; carrier < static_cast<int>(at_.size()); ++carrier) {
      if (!in_[carrier] || carrier == own || at_[carrier] <= left || at_[carrier] >= right)
        continue;
      const CarriagePass* next = next_use(carrier);
      const bool wanted_left =
          !next || next->kind == Kind::carry_out || next->travel == Side::right;
      int edge = wanted_left ? left : right;
      if (next && next->kind == Kind::yarn)
        edge = wanted_left ? std::min(edge, column_of(next->lowest))
                           : std::max(edge, column_of(next->highest) + 1);
      move(carrier, stop(edge, wanted_left ? Side::left : Side::right, carrier),
           "carrier out of the way");
    }
  }

  const CarriagePass* next_use(int carrier) const {
    for (std::size_t p = now_; p < passes_.size(); ++p)
      if (carrier_of(passes_[p]) == carrier) return &passes_[p];
    return nullptr;
  }

  /// Beside an edge, and no nearer to another waiting carrier than they may be.
  int stop(int edge, Side side, int carrier) const {
    const int step = side == Side::left ? -1 : 1;
    const int furthest = kColumnsBeside - 1 + profile_.needles + kColumnsBeside;
    int column = edge + step * kCarrierDistance;
    const auto near_another = [&] {
      for (int other = 1; other < static_cast<int>(at_.size()); ++other)
        if (other != carrier && in_[other] && std::abs(at_[other] - column) < kCarrierSpacing)
          return true;
      return false;
    };
    while (near_another() && column > 1 && column < furthest) column += step;
    return column;
  }

  /// A sweep that makes no loop and takes a carrier along.
  void move(int carrier, int to, const std::string& why) {
    face(to > at_[carrier] ? Side::right : Side::left);
    KcodePass empty = empty_sweep(why);
    carry(empty, carrier, to);
    sweeps_.push_back(std::move(empty));
  }

  void carry(KcodePass& sweep, int carrier, int to) {
    sweep.carrier = carrier;
    sweep.carrier_left = std::min(at_[carrier], to);
    sweep.carrier_right = std::max(at_[carrier], to);
    at_[carrier] = to;
    if (sweep.carriage_left == 0) sweep.carriage_left = sweep.carrier_left;
    if (sweep.carriage_right == 0) sweep.carriage_right = sweep.carrier_right;
    sweep.carriage_left = std::min(sweep.carriage_left, sweep.carrier_left);
    sweep.carriage_right = std::max(sweep.carriage_right, sweep.carrier_right);
  }

  KcodePass empty_sweep(const std::string& why) const {
    KcodePass empty;
    empty.direction = next_way();
    empty.racking = sweeps_.empty() ? 0.0 : sweeps_.back().racking;
    empty.speed = kEmptySpeed;
    empty.comment = why;
    return empty;
  }

  /// Brings the carriage to the side from which it can go this way.
  void face(Side way) {
    if (next_way() != way) sweeps_.push_back(empty_sweep("carriage to the other side"));
  }

  Side next_way() const {
    if (sweeps_.empty()) return Side::right;
    return sweeps_.back().direction == Side::right ? Side::left : Side::right;
  }

  // The carriage turns where the further of two sweeps needs it to. One that does nothing goes as
  // far as its neighbours.
  void turn_at_outermost_stops() {
    for (std::size_t s = 0; s < sweeps_.size(); ++s) {
      KcodePass& empty = sweeps_[s];
      if (empty.carriage_right > 0) continue;
      const KcodePass& before = sweeps_[s > 0 ? s - 1 : s + 1];
      const KcodePass& after = sweeps_[s + 1];
      empty.carriage_left = std::min(before.carriage_left, after.carriage_left);
      empty.carriage_right = std::max(before.carriage_right, after.carriage_right);
    }
    for (std::size_t s = 0; s + 1 < sweeps_.size(); ++s) {
      KcodePass &a = sweeps_[s], &b = sweeps_[s + 1];
      if (a.direction == Side::right)
        a.carriage_right = b.carriage_right = std::max(a.carriage_right, b.carriage_right);
      else
        a.carriage_left = b.carriage_left = std::min(a.carriage_left, b.carriage_left);
    }
  }

  const Program& program_;
  const MachineProfile& profile_;
  std::vector<CarriagePass> passes_;
  std::vector<KcodePass> sweeps_;
  std::vector<int> at_;   // [carrier] column
  std::vector<bool> in_;  // [carrier]
  std::size_t now_ = 0;
  int read_ = 0;  // instructions whose settings are in force
  KcodeSettings settings_;
};

}  // namespace

std::vector<KcodePass> plan_kcode(const Program& program, const MachineProfile& profile) {
  return Planner(program, profile).run();
}

double kcode_minutes(const std::vector<KcodePass>& sweeps, const MachineProfile& profile) {
  double seconds = 0.0;
  for (const KcodePass& sweep : sweeps)
    seconds += profile.seconds_per_turn +
               (sweep.carriage_right - sweep.carriage_left) / profile.needles_per_second;
  return seconds / 60.0;
}

}  // namespace meshknit
