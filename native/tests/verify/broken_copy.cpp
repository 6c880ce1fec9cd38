#include "verify/broken_copy.h"

#include <gtest/gtest.h>

#include "meshknit/verify/verify_knitout.h"

namespace meshknit {

void expect_refused(const std::vector<BrokenCopy>& copies, const KnitoutLines& good,
                    const StitchTrace& trace) {
  const MachineProfile profile = machine_profile("shima_swg091n2");
  ASSERT_TRUE(verify_knitout(good.text(), profile, trace).ok);
  for (const BrokenCopy& copy : copies) {
    KnitoutLines lines = good;
    copy.damage(lines);
    const VerifyReport report = verify_knitout(lines.text(), profile, trace);
    EXPECT_FALSE(report.ok) << copy.what;
    const Problem* problem = find_problem(report.problems, copy.code);
    if (!problem) {
      ADD_FAILURE() << copy.what << ": no " << copy.code;
      for (const Problem& p : report.problems) {
        ADD_FAILURE() << "  instead " << p.code << ": " << p.message;
      }
    } else {
      EXPECT_EQ(problem->severity, Severity::error) << copy.what;
    }
    for (const Problem& other : report.problems) {
      EXPECT_TRUE(!copy.alone || other.code == copy.code) << copy.what << ": " << other.code;
    }
  }
}

}  // namespace meshknit
