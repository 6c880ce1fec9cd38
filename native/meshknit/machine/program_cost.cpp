#include <algorithm>
#include <cmath>

#include "meshknit/machine/carriage_passes.h"

namespace meshknit {
namespace {

void see(ProgramCost& cost, const Needle& needle) {
  cost.lowest_needle = std::min(cost.lowest_needle, needle.index);
  cost.highest_needle = std::max(cost.highest_needle, needle.index);
}

}  // namespace

ProgramCost measure_program(const Program& program, const MachineProfile& profile) {
  ProgramCost cost;
  for (const Instruction& i : program.instructions)
    if (i.op == Op::rack) cost.max_racking = std::max(cost.max_racking, std::abs(i.racking));
  long travelled = 0;
  for (const CarriagePass& pass : carriage_passes(program, profile)) {
    ++cost.passes;
    if (pass.kind == CarriagePass::Kind::release || pass.kind == CarriagePass::Kind::carry_out)
      continue;
    travelled += static_cast<long>(pass.highest) - pass.lowest + 1;
    for (const int index : pass.instructions) {
      const Instruction& i = program.instructions[index];
      if (cost.operations++ == 0) cost.lowest_needle = cost.highest_needle = i.needle.index;
      see(cost, i.needle);
      if (i.op != Op::xfer && i.op != Op::split) continue;
      see(cost, i.target);
      if (i.carriers.empty()) ++cost.transfers;
    }
  }
  for (const std::string& carrier : profile.carriers)
    if (std::any_of(program.instructions.begin(), program.instructions.end(),
                    [&](const Instruction& i) {
                      return (i.op == Op::knit || i.op == Op::tuck || i.op == Op::split) &&
                             std::count(i.carriers.begin(), i.carriers.end(), carrier) > 0;
                    }))
      cost.carriers.push_back(carrier);
  const double seconds = cost.passes * profile.seconds_per_turn +
                         static_cast<double>(travelled) / profile.needles_per_second;
  cost.estimated_minutes = seconds / 60.0;
  return cost;
}

}  // namespace meshknit
