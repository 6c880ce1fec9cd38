#include "meshknit/core/parallel.h"

#include <gtest/gtest.h>

#include <atomic>
#include <stdexcept>
#include <string>
#include <vector>

namespace meshknit {
namespace {

TEST(Team, DoesEverythingOnce) {
  std::vector<int> done(1000, 0);
  Team(8).for_each(1000, [&](int k, int) { ++done[k]; });
  EXPECT_EQ(done, std::vector<int>(1000, 1));
  Team(8).for_each(0, [&](int, int) { FAIL() << "there is nothing to do"; });
}

TEST(Team, NoTwoThreadsAreTheSameWorker) {
  Team team(200);
  std::vector<int> at_work(static_cast<std::size_t>(team.workers()), 0);
  std::vector<int> done(at_work.size(), 0);
  team.for_each(200, [&](int, int worker) {
    EXPECT_EQ(at_work.at(worker)++, 0);
    ++done[worker];
    --at_work[worker];
  });
  int sum = 0;
  for (const int of_worker : done) sum += of_worker;
  EXPECT_EQ(sum, 200);
}

// Two fail; whichever happens to fail first, the plain loop's failure is told.
TEST(Team, ToldOfTheFirstFailureInOrder) {
  for (int round = 0; round < 200; ++round) {
    std::atomic<int> spun{0};
    try {
      Team(8).for_each(8, [&](int k, int) {
        // Now the one takes longer, now the other.
        while (k == 2 + round % 2 && ++spun < 20000) {
        }
        if (k == 2 || k == 3) throw std::runtime_error(std::to_string(k));
      });
      FAIL() << "the failure was swallowed";
    } catch (const std::runtime_error& failure) {
      EXPECT_STREQ(failure.what(), "2");
    }
  }
}

// The rounds of a relaxation: what one helping leaves is there for the next.
TEST(Team, WorkComesInManyHelpings) {
  Team team(3);
  std::vector<int> values(64, 0);
  for (int round = 0; round < 500; ++round) {
    const std::vector<int> before = values;
    team.for_each(64, [&](int k, int) { values[k] = before[(k + 1) % 64] + 1; });
  }
  EXPECT_EQ(values, std::vector<int>(64, 500));
}

TEST(Team, StopsAfterAFailure) {
  std::atomic<int> begun{0};
  EXPECT_THROW(Team(8).for_each(1000000,
                                [&](int k, int) {
                                  ++begun;
                                  if (k == 10) throw std::runtime_error("enough");
                                }),
               std::runtime_error);
  EXPECT_LT(begun, 1000000);
}

}  // namespace
}  // namespace meshknit
