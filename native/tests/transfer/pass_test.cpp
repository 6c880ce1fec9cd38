#include "meshknit/transfer/pass.h"

#include <gtest/gtest.h>

#include "meshknit/transfer/transfer_problem.h"

namespace meshknit {
namespace {

TEST(Pass, ComesDownWhereTheNeedlesFaceEachOther) {
  // For every pass and either kind of needle: the transfer to the shifted place happens at the
  // racking of the pass.
  for (const Bed from : {Bed::front, Bed::back}) {
    for (int racking = -5; racking <= 5; ++racking) {
      const Pass pass{from, racking};
      for (const bool parked : {false, true}) {
        if (parked && changes_side(pass)) continue;
        const bool parks = !changes_side(pass) && !parked;
        const Transfer transfer{{from, 7, parked}, {opposite(from), 7 + shift_of(pass), parks}};
        EXPECT_EQ(racking_of(transfer), racking);
      }
    }
  }
}

TEST(Pass, TravelStartsAndEndsAtRackingZero) {
  EXPECT_EQ(racking_travel({}), 0);
  // 0 -> 2 -> -1 -> 0
  EXPECT_EQ(racking_travel({{Bed::front, 2}, {Bed::back, -1}}), 2 + 3 + 1);
}

TEST(Pass, APassEndsWhenTheRackingOrTheDirectionChanges) {
  const auto front = [](int n, bool parked = false) { return Place{Bed::front, n, parked}; };
  const auto back = [](int n, bool parked = false) { return Place{Bed::back, n, parked}; };
  TransferPlan plan;
  EXPECT_EQ(count_passes(plan), 0);
  plan.transfers = {{front(0), back(0, true)}, {front(1), back(1, true)}};  // both at 0
  EXPECT_EQ(count_passes(plan), 1);
  plan.transfers.push_back({back(0, true), front(0)});  // the other direction
  EXPECT_EQ(count_passes(plan), 2);
  plan.transfers.push_back({back(1, true), front(2)});  // another racking
  EXPECT_EQ(count_passes(plan), 3);
}

}  // namespace
}  // namespace meshknit
