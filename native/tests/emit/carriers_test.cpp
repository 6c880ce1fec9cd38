#include "meshknit/emit/carriers.h"

#include <gtest/gtest.h>

#include <algorithm>

#include "meshknit/core/error.h"

namespace meshknit {
namespace {

/// Yarns by their stitches, in order.
StitchTrace trace_of(const std::vector<int>& yarn_of_stitch) {
  StitchTrace trace;
  for (const int yarn : yarn_of_stitch) {
    Stitch stitch;
    stitch.yarn = yarn;
    stitch.node = static_cast<int>(trace.stitches.size());
    trace.stitches.push_back(stitch);
    trace.yarns = std::max(trace.yarns, yarn + 1);
  }
  return trace;
}

MachineProfile machine_with(const std::vector<std::string>& carriers, const std::string& waste,
                            const std::string& yarn) {
  MachineProfile profile;
  profile.carriers = carriers;
  profile.waste_carrier = waste;
  profile.yarn_carrier = yarn;
  return profile;
}

std::vector<std::string> names(const std::vector<YarnUse>& uses) {
  std::vector<std::string> carriers;
  for (const YarnUse& use : uses) carriers.push_back(use.carrier);
  return carriers;
}

TEST(Carriers, ACarrierIsFreeAgainWhenItsYarnHasEnded) {
  const MachineProfile machine = machine_with({"1", "2", "3", "4"}, "1", "2");
  EXPECT_EQ(names(assign_carriers(trace_of({0, 1, 0, 1, 1}), machine)),
            (std::vector<std::string>{"2", "3"}));
  EXPECT_EQ(names(assign_carriers(trace_of({0, 1, 1, 2, 2}), machine)),
            (std::vector<std::string>{"2", "2", "2"}));
  // Yarn 2 begins after yarn 1 has ended and while yarn 0 is still in use.
  EXPECT_EQ(names(assign_carriers(trace_of({0, 1, 1, 2, 0}), machine)),
            (std::vector<std::string>{"2", "3", "3"}));
}

TEST(Carriers, TheWasteKeepsItsOwn) {
  const MachineProfile machine = machine_with({"1", "2", "3"}, "2", "3");
  EXPECT_EQ(names(assign_carriers(trace_of({0, 1, 0, 1}), machine)),
            (std::vector<std::string>{"3", "1"}));
}

TEST(Carriers, TooManyYarnsAtATimeAreRefusedAndNamed) {
  const MachineProfile machine = machine_with({"1", "2", "3"}, "1", "2");
  try {
    assign_carriers(trace_of({0, 1, 2, 0, 1, 2}), machine);
    FAIL() << "three yarns, two carriers";
  } catch (const NotKnittable& refused) {
    const Problem* problem = find_problem(refused.problems(), "too-many-carriers");
    ASSERT_NE(problem, nullptr);
    EXPECT_EQ(problem->elements.stitches, (std::vector<int>{0, 1, 2}));
    EXPECT_NE(problem->message.find("3 tubes"), std::string::npos) << problem->message;
    EXPECT_NE(problem->message.find("carriers for 2"), std::string::npos) << problem->message;
  }
}

TEST(Carriers, AMachineWithWasteOnlySaysThatItNeedsAnotherCarrier) {
  try {
    assign_carriers(trace_of({0, 0}), machine_with({"1"}, "1", "1"));
    FAIL() << "no carrier is left for the object";
  } catch (const NotKnittable& refused) {
    const Problem* problem = find_problem(refused.problems(), "too-many-carriers");
    ASSERT_NE(problem, nullptr);
    EXPECT_NE(problem->message.find("no carrier"), std::string::npos) << problem->message;
    EXPECT_NE(problem->remedy.find("Add a carrier"), std::string::npos) << problem->remedy;
  }
}

}  // namespace
}  // namespace meshknit
