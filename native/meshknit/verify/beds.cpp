#include "meshknit/verify/beds.h"

#include <algorithm>
#include <limits>

namespace meshknit {
namespace {

bool works_needles(Op op) {
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

bool keeps_position(const Program& program) {
  return std::any_of(program.headers.begin(), program.headers.end(), [](const auto& header) {
    return header.first == "Position" && header.second == "Keep";
  });
}

int lowest_needle(const Program& program) {
  int lowest = std::numeric_limits<int>::max();
  for (const Instruction& i : program.instructions) {
    if (!works_needles(i.op)) continue;
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
