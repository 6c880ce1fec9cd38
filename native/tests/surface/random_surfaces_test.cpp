#include "random_surfaces.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <set>

namespace meshknit {
namespace {

constexpr std::uint32_t seeds = 40;

const std::vector<RandomSurface>& surfaces() {
  static const std::vector<RandomSurface> made = [] {
    std::vector<RandomSurface> all;
    for (std::uint32_t seed = 0; seed < seeds; ++seed) all.push_back(random_surface(seed));
    return all;
  }();
  return made;
}

TEST(RandomSurfaces, AreReadyToKnit) {
  for (std::uint32_t seed = 0; seed < seeds; ++seed) {
    SCOPED_TRACE(seed);
    const RandomSurface& random = surfaces()[seed];
    SurfaceOptions options;
    options.stitch_width = random.gauge.stitch_width;
    const Surface surface = make_surface(random.shape.vertices, random.shape.faces, options);
    EXPECT_TRUE(surface.problems.empty());
    EXPECT_EQ(surface.components, 1);
    EXPECT_EQ(surface.genus, random.handles);
    EXPECT_EQ(surface.boundaries.size(), random.shape.times.size());
    EXPECT_TRUE(check_constraints(surface, time_constraints(surface, random.shape)).empty());
    const TimeFieldCheck check = check_time_field(surface, random.timed.time);
    EXPECT_FALSE(has_errors(check.problems));
    EXPECT_EQ(check.extrema, 0);
    EXPECT_EQ(check.saddles, check.expected_saddles);
    const double nodes =
        surface.area / (random.gauge.stitch_width * 2.0 * random.gauge.stitch_height);
    EXPECT_GE(nodes, 299.0);
    EXPECT_LE(nodes, 6150.0);
  }
}

TEST(RandomSurfaces, StartAtTheFirstTimeAndEndAtTheLast) {
  for (const RandomSurface& random : surfaces()) {
    std::set<double> times;
    for (const TimeMark& mark : random.shape.times) times.insert(mark.time);
    EXPECT_EQ(*times.begin(), -1.0);
    EXPECT_EQ(*times.rbegin(), 1.0);
  }
}

TEST(RandomSurfaces, HoldSplitsMergesHandlesAndRimsBetween) {
  int many_starts = 0, many_ends = 0, handles = 0, between = 0, many_rims = 0;
  for (const RandomSurface& random : surfaces()) {
    const std::vector<TimeMark>& times = random.shape.times;
    const auto count = [&](auto holds) {
      return std::count_if(times.begin(), times.end(), holds);
    };
    many_starts += count([](const TimeMark& m) { return m.time < 0.0; }) > 1;
    many_ends += count([](const TimeMark& m) { return m.time > 0.0; }) > 1;
    between += count([](const TimeMark& m) { return m.time > -1.0 && m.time < 1.0; }) > 0;
    handles += random.handles > 0;
    many_rims += times.size() > 4;
  }
  // Of 40; a kind that is there by accident only would be no test of anything.
  for (const int kind : {many_starts, many_ends, handles, between, many_rims})
    EXPECT_GE(kind, 4);
}

TEST(RandomSurfaces, HaveNoSlivers) {
  for (std::uint32_t seed = 0; seed < seeds; ++seed)
    EXPECT_GT(smallest_angle(surfaces()[seed].shape), 5.0) << "seed " << seed;
}

TEST(RandomSurfaces, AreTheSameForTheSameSeed) {
  const RandomSurface again = random_surface(3);
  EXPECT_EQ(again.shape.vertices, surfaces()[3].shape.vertices);
  EXPECT_EQ(again.shape.faces, surfaces()[3].shape.faces);
  EXPECT_NE(again.shape.vertices.rows(), surfaces()[4].shape.vertices.rows());
}

}  // namespace
}  // namespace meshknit
