#include "meshknit/verify/kcode_check.h"

#include <algorithm>
#include <string>
#include <vector>

#include "meshknit/knitout/kcode.h"
#include "meshknit/knitout/knitout_reader.h"
#include "meshknit/verify/fabric.h"
#include "meshknit/verify/problem_log.h"
#include "meshknit/verify/replay.h"

namespace meshknit {
namespace {

struct Way {
  int left = 0, right = 0;  // columns of the needles at work; equal if there are none
};

Way needles_at_work(const KcodePass& pass) {
  std::vector<int> columns;
  for (const int n : pass.front) columns.push_back(column_of(n));
  for (const int n : pass.rear)
    columns.push_back(column_of(n) + static_cast<int>(pass.racking));
  if (columns.empty()) return {};
  const auto [least, most] = std::minmax_element(columns.begin(), columns.end());
  return {*least, *most + 1};
}

void check_carriers(const std::vector<KcodePass>& passes, std::size_t carriers,
                    ProblemLog& log) {
  std::vector<int> at(carriers + 1, kParkingColumn);
  for (const KcodePass& pass : passes) {
    const Way way = needles_at_work(pass);
    const bool right = pass.direction == Side::right;
    const int start = right ? pass.carrier_left : pass.carrier_right;
    const int end = right ? pass.carrier_right : pass.carrier_left;
    if (pass.carrier > 0) {
      const bool passes_all = way.left == way.right || (pass.carrier_left <= way.left &&
                                                        pass.carrier_right >= way.right);
      if (start != at[pass.carrier] || !passes_all)
        log.error("carrier-elsewhere", pass.line,
                  "carrier " + std::to_string(pass.carrier) +
                      " does not come from where it stopped, past all needles at work");
      at[pass.carrier] = end;
    }
    for (std::size_t other = 1; other <= carriers; ++other)
      if (static_cast<int>(other) != pass.carrier && at[other] > way.left &&
          at[other] < way.right)
        log.error("carrier-in-the-way", pass.line,
                  "carrier " + std::to_string(other) + " waits above needles at work");
  }
}

bool same_way_of_making(const Fabric& a, const Loop& x, const Fabric& b, const Loop& y) {
  const bool same_parents =
      x.parents == y.parents && std::equal(a.parents.begin() + x.first_parent,
                                           a.parents.begin() + x.first_parent + x.parents,
                                           b.parents.begin() + y.first_parent);
  return same_parents && x.made_by == y.made_by && x.direction == y.direction &&
         x.made_on == y.made_on && x.hangs_on == y.hangs_on && x.fate == y.fate &&
         a.yarns[x.yarn].carrier == b.yarns[y.yarn].carrier;
}

void compare(const Fabric& made, const Fabric& wanted, ProblemLog& log) {
  const std::size_t count = std::min(made.loops.size(), wanted.loops.size());
  for (std::size_t id = 0; id < count; ++id)
    if (!same_way_of_making(made, made.loops[id], wanted, wanted.loops[id]))
      log.error("kcode-differs", made.loops[id].line,
                "loop " + std::to_string(id) + " is not that of line " +
                    std::to_string(wanted.loops[id].line) + " of the knitout file",
                {named_stitch(wanted.loops[id])});
  if (made.loops.size() != wanted.loops.size())
    log.error("kcode-differs", 0,
              "The .kc file makes " + std::to_string(made.loops.size()) +
                  " loops, the knitout file " + std::to_string(wanted.loops.size()));
}

}  // namespace

Problems check_kcode(std::string_view kcode, std::string_view knitout,
                     const MachineProfile& profile) {
  const KcodeText read = read_kcode(kcode, profile.needles);
  if (!read.problems.empty()) return read.problems;
  ProblemLog log;
  for (const KcodePass& pass : read.passes)
    if (pass.carrier > static_cast<int>(profile.carriers.size())) {
      log.error("bad-kcode", pass.line, "the machine has no such carrier");
      return log.problems();
    }
  check_carriers(read.passes, profile.carriers.size(), log);
  // Machine rules are judged on the knitout file; here the two need only agree.
  ProblemLog judged_elsewhere;
  compare(replay_program(program_of(read.passes, profile), profile, judged_elsewhere),
          replay_program(read_knitout(knitout).program, profile, judged_elsewhere), log);
  return log.problems();
}

}  // namespace meshknit
