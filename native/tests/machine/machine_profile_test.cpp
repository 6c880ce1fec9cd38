#include "meshknit/machine/machine_profile.h"

#include <gtest/gtest.h>

#include <algorithm>

#include "meshknit/core/error.h"

namespace meshknit {
namespace {

TEST(MachineProfile, EveryNamedProfileIsUsable) {
  for (const std::string& name : machine_profile_names()) {
    const MachineProfile p = machine_profile(name);
    EXPECT_EQ(p.name, name);
    const auto has = [&](const std::string& carrier) {
      return std::count(p.carriers.begin(), p.carriers.end(), carrier) == 1;
    };
    EXPECT_TRUE(has(p.waste_carrier));
    EXPECT_TRUE(has(p.yarn_carrier));
    EXPECT_NE(p.waste_carrier, p.yarn_carrier);
    EXPECT_GT(p.seconds_per_turn, 0.0);
    EXPECT_GT(p.needles_per_second, 0.0);
    // Neighbouring loops at half gauge lie 2 needles apart, across the beds 1; a decrease must
    // fit.
    EXPECT_GE(p.max_stretch, 2);
    EXPECT_GE(p.max_float, p.max_stretch);
    EXPECT_GE(p.max_stack, 2);
  }
}

TEST(MachineProfile, YarnsLeaveWasteAndDrawThreadTheirCarriers) {
  using Names = std::vector<std::string>;
  EXPECT_EQ(carriers_for_yarn(machine_profile("kniterate")), (Names{"2", "3", "4", "5"}));
  EXPECT_EQ(carriers_for_yarn(machine_profile("shima_swg091n2")),
            (Names{"2", "3", "4", "5", "6", "7", "8", "9", "10"}));
  MachineProfile p;
  p.carriers = {"a", "b", "c"};
  p.waste_carrier = "c";
  p.yarn_carrier = "b";
  EXPECT_EQ(carriers_for_yarn(p), (Names{"b", "a"}));
}

TEST(MachineProfile, AnUnknownMachineIsNamedAndTheKnownOnesListed) {
  try {
    machine_profile("hand_needles");
    FAIL() << "no throw";
  } catch (const InvalidInput& e) {
    const std::string what = e.what();
    EXPECT_NE(what.find("hand_needles"), std::string::npos);
    EXPECT_NE(what.find("shima_swg091n2"), std::string::npos);
  }
}

}  // namespace
}  // namespace meshknit
