#include "meshknit/core/parallel.h"

#include <gtest/gtest.h>

#include <atomic>
#include <stdexcept>
#include <string>
#include <vector>

namespace meshknit {
namespace {

TEST(Parallel, DoesEverythingOnce) {
  std::vector<int> done(1000, 0);
  for_each_in_parallel(1000, [&](int k, int) { ++done[k]; });
  EXPECT_EQ(done, std::vector<int>(1000, 1));
  for_each_in_parallel(0, [&](int, int) { FAIL() << "there is nothing to do"; });
}

TEST(Parallel, NoTwoThreadsAreTheSameWorker) {
  std::vector<int> at_work(static_cast<std::size_t>(workers_for(200)), 0);
  std::vector<int> done(at_work.size(), 0);
  for_each_in_parallel(200, [&](int, int worker) {
    EXPECT_EQ(at_work.at(worker)++, 0);
    ++done[worker];
    --at_work[worker];
  });
  int sum = 0;
  for (const int of_worker : done) sum += of_worker;
  EXPECT_EQ(sum, 200);
}

// Two fail; whichever happens to fail first, the plain loop's failure is told.
TEST(Parallel, ToldOfTheFirstFailureInOrder) {
  for (int round = 0; round < 200; ++round) {
    std::atomic<int> spun{0};
    try {
      for_each_in_parallel(8, [&](int k, int) {
        // The first to fail takes longer than the second.
        while (k == 2 && ++spun < 2000) {
        }
        if (k == 2 || k == 3) throw std::runtime_error(std::to_string(k));
      });
      FAIL() << "the failure was swallowed";
    } catch (const std::runtime_error& failure) {
      EXPECT_STREQ(failure.what(), "2");
    }
  }
}

TEST(Parallel, StopsAfterAFailure) {
  std::atomic<int> begun{0};
  EXPECT_THROW(for_each_in_parallel(1000000,
                                    [&](int k, int) {
                                      ++begun;
                                      if (k == 10) throw std::runtime_error("enough");
                                    }),
               std::runtime_error);
  EXPECT_LT(begun, 1000000);
}

}  // namespace
}  // namespace meshknit
