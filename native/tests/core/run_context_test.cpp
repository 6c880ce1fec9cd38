#include "meshknit/core/run_context.h"

#include <gtest/gtest.h>

#include "meshknit/core/error.h"

namespace meshknit {
namespace {

TEST(RunContext, ProgressIsTheStagesShareAndNeverGoesBack) {
  RunContext run;
  run.begin_stage(0.2, 0.6);
  run.report(0.5);
  EXPECT_DOUBLE_EQ(run.progress(), 0.4);
  run.report(0.1);
  EXPECT_DOUBLE_EQ(run.progress(), 0.4);
  run.report(7.0);
  EXPECT_DOUBLE_EQ(run.progress(), 0.6);
}

TEST(RunContext, ACancelledRunStopsAtTheNextReport) {
  RunContext run;
  run.report(0.1);
  run.cancel();
  EXPECT_THROW(run.report(0.2), Cancelled);
  EXPECT_THROW(run.report(0.3), Cancelled) << "cancelling is sticky";
  EXPECT_DOUBLE_EQ(run.progress(), 0.1);
}

}  // namespace
}  // namespace meshknit
