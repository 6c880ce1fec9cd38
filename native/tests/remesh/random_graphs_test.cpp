// Surfaces that nobody drew; bench_random_surfaces tries many more.

#include <gtest/gtest.h>

#include "meshknit/core/error.h"
#include "meshknit/knit_graph/knit_graph_checks.h"
#include "random_surfaces.h"

namespace meshknit {
namespace {

// Not those of the generator's own tests.
constexpr std::uint32_t first_seed = 2000, seeds = 40;

TEST(RandomGraphs, CanBeKnitAndBranchAsTheirFieldsDo) {
  int splits = 0, merges = 0, refused = 0;
  for (std::uint32_t seed = first_seed; seed < first_seed + seeds; ++seed) {
    SCOPED_TRACE(seed);
    const RandomSurface random = random_surface(seed);
    KnitGraph graph;
    try {
      graph = remesh(random.timed.surface, random.timed.time, random.gauge);
    } catch (const NotKnittable& refusal) {
      ++refused;
      EXPECT_FALSE(refusal.problems().front().remedy.empty());
      EXPECT_FALSE(refusal.problems().front().elements.faces.empty()) << "it names a place";
      continue;
    }
    for (const Problem& problem : check_knit_graph(graph).problems)
      EXPECT_NE(problem.severity, Severity::error) << problem.message;
    const KnitGraphStats stats = measure_graph(graph);
    // A row where one saddle's tubes meet and another's part counts for both, a row that parts
    // into three for two saddles.
    EXPECT_LE(stats.splits + stats.merges,
              check_time_field(random.timed.surface, random.timed.time).expected_saddles);
    splits += stats.splits;
    merges += stats.merges;
  }
  // Tips without an opening may be too thin to be reached, but seldom.
  EXPECT_LE(refused, 1);
  EXPECT_GE(splits, static_cast<int>(seeds) / 2);
  EXPECT_GE(merges, static_cast<int>(seeds) / 2);
}

}  // namespace
}  // namespace meshknit
