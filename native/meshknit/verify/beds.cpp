#include "meshknit/verify/beds.h"

#include <algorithm>
#include <limits>

#include "meshknit/machine/carriage_passes.h"

namespace meshknit {
namespace {

bool keeps_position(const Program& program) {
  return std::any_of(program.headers.begin(), program.headers.end(), [](const auto& header) {
    return header.first == "Position" && header.second == "Keep";
  });
}

int lowest_needle(const Program& program) {
  int lowest = std::numeric_limits<int>::max();
  for (const Instruction& i : program.instructions) {
    if (!is_needle_operation(i.op)) continue;
    lowest = std::min(lowest, i.needle.index);
    if (i.op == Op::xfer || i.op == Op::split) lowest = std::min(lowest, i.target.index);
  }
  return lowest == std::numeric_limits<int>::max() ? 1 : lowest;
}

}  // namespace

BedRange::BedRange(const Program& program, const MachineProfile& profile)
    : lowest_(keeps_position(program) ? 1 : lowest_needle(program)),
      width_(std::max(profile.needles, 0)) {}

}  // namespace meshknit
