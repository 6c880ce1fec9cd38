#include "meshknit/pipeline/knit_parts.h"

#include <algorithm>

#include "meshknit/machine/carriage_passes.h"

namespace meshknit {
namespace {

template <class T>
void add_once(std::vector<T>& list, const T& value) {
  if (std::find(list.begin(), list.end(), value) == list.end()) list.push_back(value);
}

// The pass in which each instruction is done.
std::vector<int> pass_of(const Program& program, const MachineProfile& profile) {
  std::vector<int> pass(program.instructions.size(), 0);
  const std::vector<CarriagePass> passes = carriage_passes(program, profile);
  for (std::size_t p = 0; p < passes.size(); ++p)
    for (const int i : passes[p].instructions) pass[i] = static_cast<int>(p);
  return pass;
}

}  // namespace

std::vector<KnitPart> find_parts(const Program& program, const StitchTrace& trace,
                                 const MachineProfile& profile) {
  const std::vector<int> pass = pass_of(program, profile);
  std::vector<int> made_in(trace.stitches.size(), 0);  // [stitch] pass
  std::vector<KnitPart> parts;
  std::vector<int> part_of(trace.tubes, -1);  // [tube]
  for (std::size_t i = 0; i < program.instructions.size(); ++i) {
    const Instruction& instruction = program.instructions[i];
    if (instruction.source.kind != Source::Kind::stitch) continue;
    const int s = instruction.source.stitch;
    const Stitch& stitch = trace.stitches[s];
    const int needle = instruction.needle.index;
    if (part_of[stitch.tube] < 0) {
      part_of[stitch.tube] = static_cast<int>(parts.size());
      KnitPart part;
      part.tube = stitch.tube;
      part.line = instruction.line;
      part.lowest = part.highest = needle;
      parts.push_back(std::move(part));
    }
    KnitPart& part = parts[part_of[stitch.tube]];
    part.lowest = std::min(part.lowest, needle);
    part.highest = std::max(part.highest, needle);
    add_once(part.carriers, instruction.carriers.front());
    part.starts += stitch.kind == StitchKind::start ? 1 : 0;
    part.ends += stitch.kind == StitchKind::end ? 1 : 0;
    made_in[s] = pass[i];
    for (const int parent : stitch.parents) {
      const int below = trace.stitches[parent].tube;
      if (below != stitch.tube) {
        add_once(part.from, below);
        add_once(parts[part_of[below]].into, stitch.tube);
      }
      if (made_in[s] - made_in[parent] <= part.longest_wait) continue;
      part.longest_wait = made_in[s] - made_in[parent];
      part.wait_line = instruction.line;
    }
  }
  return parts;
}

}  // namespace meshknit
