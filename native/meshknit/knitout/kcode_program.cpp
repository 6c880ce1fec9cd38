#include <algorithm>
#include <cmath>
#include <utility>

#include "meshknit/knitout/kcode.h"

namespace meshknit {
namespace {

class Translation {
 public:
  explicit Translation(const MachineProfile& profile)
      : profile_(profile), in_(profile.carriers.size() + 1, false) {
    program_.carriers = profile.carriers;
    if (!profile.machine_header.empty())
      program_.headers.emplace_back("Machine", profile.machine_header);
    program_.headers.emplace_back("Position", "Keep");
  }

  void add(const KcodePass& pass) {
    pass_ = &pass;
    if (pass.racking != racking_) {
      racking_ = pass.racking;
      add(Op::rack).racking = racking_;
    }
    if (pass.carrier > 0 && !in_[pass.carrier]) {
      in_[pass.carrier] = true;
      add(Op::in).carriers = carriers();
    }
    if (pass.kind == KcodePass::Kind::yarn)
      add_loops();
    else
      add_transfers();
    const bool parks =
        pass.carrier > 0 && pass.direction == Side::left && pass.carrier_left == kParkingColumn;
    if (!parks) return;
    in_[pass.carrier] = false;
    add(Op::out).carriers = carriers();
  }

  Program take() { return std::move(program_); }

 private:
  std::vector<std::string> carriers() const {
    if (pass_->carrier == 0) return {};
    return {profile_.carriers[static_cast<std::size_t>(pass_->carrier) - 1]};
  }

  Instruction& add(Op op) {
    Instruction instruction;
    instruction.op = op;
    instruction.line = pass_->line;
    program_.instructions.push_back(std::move(instruction));
    return program_.instructions.back();
  }

  void add_loops() {
    // Where beds stand a fraction apart the front needle comes first, going right.
    std::vector<std::pair<int, Needle>> places;
    const int shift = static_cast<int>(std::floor(pass_->racking));
    for (const int n : pass_->front) places.push_back({n, {Bed::front, n, false}});
    for (const int n : pass_->rear) places.push_back({n + shift, {Bed::back, n, false}});
    std::sort(places.begin(), places.end());
    if (pass_->direction == Side::left) std::reverse(places.begin(), places.end());
    for (const auto& place : places) {
      const bool tucks =
          place.second.bed == Bed::front ? pass_->front_tucks : pass_->rear_tucks;
      const bool yarn = pass_->carrier > 0;
      Instruction& made =
          add(tucks ? (yarn ? Op::tuck : Op::amiss) : (yarn ? Op::knit : Op::drop));
      made.needle = place.second;
      made.direction = pass_->direction;
      made.carriers = carriers();
    }
  }

  void add_transfers() {
    const bool to_back = pass_->kind == KcodePass::Kind::front_to_back;
    for (std::size_t k = 0; k < pass_->front.size(); ++k) {
      const Needle front{Bed::front, pass_->front[k], false};
      const Needle back{Bed::back, pass_->rear[k], false};
      Instruction& moved = add(Op::xfer);
      moved.needle = to_back ? front : back;
      moved.target = to_back ? back : front;
    }
  }

  const MachineProfile& profile_;
  Program program_;
  std::vector<bool> in_;  // [carrier]
  const KcodePass* pass_ = nullptr;
  double racking_ = 0.0;
};

}  // namespace

Program program_of(const std::vector<KcodePass>& passes, const MachineProfile& profile) {
  Translation translation(profile);
  for (const KcodePass& pass : passes) translation.add(pass);
  return translation.take();
}

}  // namespace meshknit
