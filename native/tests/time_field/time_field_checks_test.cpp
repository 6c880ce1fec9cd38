#include <gtest/gtest.h>

#include <cmath>
#include <limits>

#include "meshknit/core/error.h"
#include "meshknit/time_field/critical_spots.h"
#include "meshknit/time_field/time_field.h"
#include "surface/test_meshes.h"

namespace meshknit {
namespace {

// 24 x 12 quads; vertex (ring, i) is 24 ring + i. The lower rim is boundary 0.
class OnATube : public testing::Test {
 protected:
  OnATube() {
    const MeshArrays arrays = tube({24, 12});
    surface = make_surface(arrays.vertices, arrays.faces);
    for (const auto v : surface.mesh.vertices())
      height.push_back(2.0 * surface.mesh.point(v).z() / 100.0 - 1.0);
  }
  bool checks_find(const std::vector<TimeConstraint>& constraints, const std::string& code) {
    const Problem* found = find_problem(check_constraints(surface, constraints), code);
    return found != nullptr;
  }
  Surface surface;
  std::vector<double> height;  // a good field
};

TEST_F(OnATube, HeightIsAGoodTime) {
  const TimeFieldCheck check = check_time_field(surface, height);
  EXPECT_TRUE(check.problems.empty());
  EXPECT_EQ(check.extrema, 0);
  EXPECT_EQ(check.saddles, 0);
  EXPECT_EQ(check.expected_saddles, 0);
}

TEST_F(OnATube, ABumpInAUsersFieldIsFoundAtItsVertex) {
  std::vector<double> time = height;
  time[24 * 4 + 7] = 0.9;   // a late spot on early cloth
  time[24 * 8 + 2] = -0.9;  // an early spot on late cloth
  const TimeFieldCheck check = check_time_field(surface, time);
  EXPECT_EQ(check.extrema, 2);
  EXPECT_EQ(check.saddles, 2) << "every false extremum brings a saddle";
  const Problem* problem = find_problem(check.problems, "false-extremum");
  ASSERT_NE(problem, nullptr);
  EXPECT_EQ(problem->elements.vertices, (std::vector<int>{24 * 4 + 7, 24 * 8 + 2}));
}

TEST_F(OnATube, TimeMustNotChangeAlongAnOpening) {
  std::vector<double> time = height;
  for (const int v : surface.boundaries[1].vertices) time[v] += 1e-7 * (v % 3);
  EXPECT_FALSE(has_errors(check_time_field(surface, time).problems)) << "rounding is forgiven";
  time[surface.boundaries[1].vertices[5]] = 0.8;
  const TimeFieldCheck check = check_time_field(surface, time);
  const Problem* problem = find_problem(check.problems, "boundary-not-constant");
  ASSERT_NE(problem, nullptr);
  EXPECT_EQ(problem->elements.boundaries, std::vector<int>{1});
}

TEST_F(OnATube, ThereMustBeAStartAndAnEnd) {
  std::vector<double> hill = height;
  for (double& t : hill) t = 1.0 - t * t;  // both rims are starts, the middle is a ridge
  const TimeFieldCheck check = check_time_field(surface, hill);
  EXPECT_NE(find_problem(check.problems, "no-end"), nullptr);
  EXPECT_EQ(find_problem(check.problems, "no-start"), nullptr);
  EXPECT_EQ(check.extrema, 1);
  for (double& t : hill) t = -t;
  EXPECT_NE(find_problem(check_time_field(surface, hill).problems, "no-start"), nullptr);
}

TEST_F(OnATube, AStandingTimeIsReported) {
  const Problem* everywhere = nullptr;
  const TimeFieldCheck still =
      check_time_field(surface, std::vector<double>(height.size(), 0.0));
  everywhere = find_problem(still.problems, "time-stands-still");
  ASSERT_NE(everywhere, nullptr);
  EXPECT_EQ(everywhere->severity, Severity::error);

  std::vector<double> belt = height;
  for (double& t : belt) t = std::abs(t) < 0.3 ? 0.0 : t;  // rings 5 to 7 of 12 at one time
  const TimeFieldCheck check = check_time_field(surface, belt);
  EXPECT_FALSE(has_errors(check.problems)) << "a belt with earlier cloth below and later above";
  const Problem* warning = find_problem(check.problems, "time-stands-still");
  ASSERT_NE(warning, nullptr);
  EXPECT_EQ(warning->elements.faces.size(), 2u * 2u * 24u);
}

TEST_F(OnATube, NonsenseIsRefused) {
  std::vector<double> time = height;
  time[30] = std::numeric_limits<double>::quiet_NaN();
  const TimeFieldCheck check = check_time_field(surface, time);
  EXPECT_EQ(find_problem(check.problems, "time-not-finite")->elements.vertices,
            std::vector<int>{30});
  EXPECT_THROW(check_time_field(surface, {0.0}), InvalidInput);
}

TEST(TimeSpots, IndicesSumToTheShapesCharacteristicWhateverTheField) {
  const MeshArrays arrays = without_quads(closed_torus(), {0, 1, 140, 141});
  const Surface surface = make_surface(arrays.vertices, arrays.faces);
  ASSERT_EQ(surface.genus, 1);
  for (const int steps : {2, 5, 1000000}) {  // coarse steps make many flat spots of every form
    Jitter jitter(11);
    std::vector<double> time;
    for (std::size_t v = 0; v < surface.mesh.n_vertices(); ++v)
      time.push_back(std::floor(steps * jitter.next()));
    for (const BoundaryLoop& loop : surface.boundaries)
      for (const int v : loop.vertices) time[v] = time[loop.vertices.front()];
    int sum = 0;
    for (const TimeSpot& spot : time_spots(surface, time, {true, true}))
      sum += 2 * spot.characteristic - spot.sign_changes;
    EXPECT_EQ(sum, 0) << "2 (2 - 2g)";
  }
}

TEST_F(OnATube, ConstraintsThatMakeSenseHaveNoProblems) {
  const auto &lower = surface.boundaries[0].vertices, &upper = surface.boundaries[1].vertices;
  EXPECT_TRUE(check_constraints(surface, {{lower, -1.0}, {upper, 1.0}}).empty());
  EXPECT_TRUE(
      check_constraints(surface, {{lower, -1.0}, {upper, 1.0}, {{30, 31}, 0.0}}).empty());
}

TEST_F(OnATube, ConstraintsThatMakeNoSenseAreExplained) {
  const auto &lower = surface.boundaries[0].vertices, &upper = surface.boundaries[1].vertices;
  const std::vector<int> half(upper.begin(), upper.begin() + 12);
  EXPECT_TRUE(checks_find({{lower, -1.5}, {upper, 1.0}}, "time-out-of-range"));
  EXPECT_TRUE(checks_find({{lower, std::nan("")}, {upper, 1.0}}, "time-out-of-range"));
  EXPECT_TRUE(checks_find({{lower, -1.0}, {upper, 1.0}, {{}, 0.0}}, "empty-constraint"));
  EXPECT_TRUE(checks_find({{lower, 0.5}, {upper, 0.5}}, "all-times-equal"));
  EXPECT_TRUE(checks_find({}, "all-times-equal"));
  EXPECT_TRUE(checks_find({{lower, -1.0}, {{30}, 1.0}}, "boundary-without-time"));
  EXPECT_TRUE(checks_find({{lower, -1.0}, {half, 1.0}}, "boundary-without-time"));
  EXPECT_TRUE(
      checks_find({{lower, -1.0}, {upper, 1.0}, {half, 0.9}}, "boundary-with-two-times"));
  EXPECT_TRUE(checks_find({{lower, -1.0}, {upper, 1.0}, {{30, 31}, 0.0}, {{31, 32}, 0.1}},
                          "contradictory-times"));
  EXPECT_THROW(check_constraints(surface, {{{-1}, 0.0}}), InvalidInput);
  EXPECT_THROW(solve_time_field(surface, {{lower, -1.0}}), NotKnittable);
}

TEST_F(OnATube, AProblemNamesTheBoundaryAndTheVerticesConcerned) {
  const auto &lower = surface.boundaries[0].vertices, &upper = surface.boundaries[1].vertices;
  const Problems problems =
      check_constraints(surface, {{lower, -1.0}, {{upper.begin(), upper.begin() + 20}, 1.0}});
  ASSERT_EQ(problems.size(), 1u);
  EXPECT_EQ(problems[0].elements.boundaries, std::vector<int>{1});
  EXPECT_EQ(problems[0].elements.vertices, std::vector<int>(upper.begin() + 20, upper.end()));
}

}  // namespace
}  // namespace meshknit
