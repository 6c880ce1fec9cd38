#include <gtest/gtest.h>

#include <string>

#include "meshknit/verify/verify_knitout.h"
#include "verify/worked_example.h"

namespace meshknit {
namespace {

VerifyReport verify(const KnitoutLines& lines) {
  return verify_knitout(lines.text(), machine_profile("shima_swg091n2"), branches_trace());
}

TEST(Branches, ATubeThatPartsAndMeetsAgainIsGood) {
  const VerifyReport report = verify(KnitoutLines::branches());
  for (const Problem& p : report.problems) ADD_FAILURE() << p.code << ": " << p.message;
  EXPECT_TRUE(report.ok);
  // 56 stitches with a loop each; all but the 8 starts go through one.
  EXPECT_EQ(report.loops, 56);
  EXPECT_EQ(report.edges, 48);
}

}  // namespace
}  // namespace meshknit
