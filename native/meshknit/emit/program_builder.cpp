#include "meshknit/emit/program_builder.h"

namespace meshknit {

Side travel(Bed bed, Direction direction) {
  const bool right = (bed == Bed::front) == (direction == Direction::anticlockwise);
  return right ? Side::right : Side::left;
}

Side reverse(Side side) { return side == Side::left ? Side::right : Side::left; }

Needle needle_of(const Hook& hook) { return half_gauge_needle({hook.bed, hook.n, false}); }

void ProgramBuilder::carrier(Op op, const std::string& carrier) {
  Instruction instruction;
  instruction.op = op;
  instruction.carriers = {carrier};
  program_.instructions.push_back(std::move(instruction));
}

void ProgramBuilder::knit(Side side, const Needle& needle, const std::string& carrier,
                          const Source& source) {
  make_loop(Op::knit, side, needle, carrier, source);
}

void ProgramBuilder::tuck(Side side, const Needle& needle, const std::string& carrier,
                          const Source& source) {
  make_loop(Op::tuck, side, needle, carrier, source);
}

void ProgramBuilder::make_loop(Op op, Side side, const Needle& needle,
                               const std::string& carrier, const Source& source) {
  rack(0);
  Instruction instruction;
  instruction.op = op;
  instruction.direction = side;
  instruction.needle = needle;
  instruction.carriers = {carrier};
  instruction.source = source;
  program_.instructions.push_back(std::move(instruction));
}

void ProgramBuilder::drop(const Needle& needle) {
  Instruction instruction;
  instruction.op = Op::drop;
  instruction.needle = needle;
  program_.instructions.push_back(std::move(instruction));
}

void ProgramBuilder::transfer(const Needle& from, const Needle& to) {
  rack(racking_between(from, to));
  Instruction instruction;
  instruction.op = Op::xfer;
  instruction.needle = from;
  instruction.target = to;
  program_.instructions.push_back(std::move(instruction));
}

void ProgramBuilder::rack(int racking) {
  if (racking == racking_) return;
  Instruction instruction;
  instruction.op = Op::rack;
  instruction.racking = racking;
  program_.instructions.push_back(std::move(instruction));
  racking_ = racking;
}

Program ProgramBuilder::finish() {
  rack(0);
  return std::move(program_);
}

}  // namespace meshknit
