#include "meshknit/suggest/rim_times.h"

#include <gtest/gtest.h>

#include <algorithm>

#include "shapes.h"

namespace meshknit {
namespace {

Surface surface_of(const std::string& name) {
  const ExampleShape shape = example_shape(name);
  return make_surface(shape.vertices, shape.faces);
}

// The boundary whose first vertex is highest, or lowest.
std::size_t outermost(const Surface& surface, bool highest) {
  const auto height = [&](const BoundaryLoop& loop) {
    const double z = surface.mesh.point(TriangleMesh::VertexHandle(loop.vertices.front())).z();
    return highest ? z : -z;
  };
  return static_cast<std::size_t>(
      std::max_element(surface.boundaries.begin(), surface.boundaries.end(),
                       [&](const auto& a, const auto& b) { return height(a) < height(b); }) -
      surface.boundaries.begin());
}

TEST(RimTimes, ATubeRunsFromTheOneEndToTheOther) {
  const Surface surface = surface_of("straight_tube");
  const std::vector<double> times = RimTimes(surface).even_times({1, 0});
  EXPECT_EQ(times, (std::vector<double>{-1.0, 1.0}));
}

TEST(RimTimes, BothLegsOfTrousersEndAtOnce) {
  const Surface surface = surface_of("trousers");
  std::vector<char> is_start(3, 0);
  const std::size_t waist = outermost(surface, true);
  is_start[waist] = 1;
  const std::vector<double> times = RimTimes(surface).even_times(is_start);
  for (std::size_t b = 0; b < 3; ++b) EXPECT_EQ(times[b], b == waist ? -1.0 : 1.0);
}

TEST(RimTimes, AThumbEndsBeforeTheFingers) {
  const Surface surface = surface_of("mitten");
  std::vector<char> is_start(3, 0);
  const std::size_t cuff = outermost(surface, false), fingers = outermost(surface, true);
  is_start[cuff] = 1;
  const std::vector<double> times = RimTimes(surface).even_times(is_start);
  EXPECT_EQ(times[cuff], -1.0);
  EXPECT_EQ(times[fingers], 1.0);
  const double thumb = times[3 - cuff - fingers];
  EXPECT_LT(thumb, 1.0);
  EXPECT_GT(thumb, 0.0);
  // As even as they are: time steps alike along the thumb and along the fingers, where the plain
  // times would hurry through the shorter one.
  EXPECT_TRUE(check_time_field(surface, RimTimes(surface).field(times)).problems.empty());
}

}  // namespace
}  // namespace meshknit
