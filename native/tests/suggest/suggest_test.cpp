#include "meshknit/suggest/suggest.h"

#include <gtest/gtest.h>

#include <algorithm>

#include "meshknit/core/error.h"
#include "meshknit/knit_graph/knit_graph_checks.h"
#include "models.h"
#include "shapes.h"
#include "surface/test_meshes.h"

namespace meshknit {
namespace {

// A shape with the marks of a suggestion instead of its own.
ExampleShape marked(ExampleShape shape, const Suggestion& suggestion) {
  shape.openings = suggestion.openings;
  shape.times = suggestion.times;
  return shape;
}

std::string errors_of_graph(const ExampleShape& shape) {
  const TimedShape ready = timed(opened(shape));
  std::string text;
  for (const Problem& problem : check_knit_graph(remesh(ready.surface, ready.time)).problems)
    if (problem.severity == Severity::error) text += problem.message + "\n";
  return text;
}

class SuggestExample : public testing::TestWithParam<std::string> {};
INSTANTIATE_TEST_SUITE_P(Suggest, SuggestExample, testing::ValuesIn(example_shape_names()),
                         [](const auto& name) { return name.param; });

TEST_P(SuggestExample, GivesMarksWithWhichTheShapeCanBeKnit) {
  const ExampleShape shape = example_shape(GetParam());
  const std::vector<Suggestion> found = suggest_marks(shape.vertices, shape.faces);
  ASSERT_FALSE(found.empty());
  EXPECT_LE(found.size(), 3u);
  for (std::size_t k = 1; k < found.size(); ++k)
    EXPECT_LE(found[k - 1].cost.total(), found[k].cost.total());
  EXPECT_EQ(errors_of_graph(marked(shape, found.front())), "") << found.front().summary;
}

TEST_P(SuggestExample, GivesTheSameTwice) {
  const ExampleShape shape = example_shape(GetParam());
  const auto once = suggest_marks(shape.vertices, shape.faces);
  const auto twice = suggest_marks(shape.vertices, shape.faces);
  ASSERT_EQ(once.size(), twice.size());
  for (std::size_t k = 0; k < once.size(); ++k) {
    EXPECT_EQ(once[k].summary, twice[k].summary);
    ASSERT_EQ(once[k].times.size(), twice[k].times.size());
    for (std::size_t i = 0; i < once[k].times.size(); ++i)
      EXPECT_EQ(once[k].times[i].time, twice[k].times[i].time);
  }
}

double time_near(const Suggestion& suggestion, const Eigen::Vector3d& place) {
  const TimeMark* nearest = nullptr;
  double least = 1e300;
  for (const TimeMark& mark : suggestion.times) {
    const Eigen::Vector3d at =
        mark.opening >= 0 ? suggestion.openings[mark.opening].at : mark.boundary_near;
    if (!((at - place).norm() < least)) continue;
    least = (at - place).norm();
    nearest = &mark;
  }
  return nearest->time;
}

TEST(Suggest, TrousersAreKnitFromTheWaistDown) {
  const ExampleShape shape = example_shape("trousers");
  const Suggestion best = suggest_marks(shape.vertices, shape.faces).front();
  EXPECT_TRUE(best.openings.empty());
  EXPECT_EQ(time_near(best, {0.0, 0.0, 100.0}), -1.0);
  EXPECT_EQ(time_near(best, {50.0, 0.0, -110.0}), 1.0);
  EXPECT_EQ(time_near(best, {-50.0, 0.0, -110.0}), 1.0);
}

TEST(Suggest, AClosedToyIsOpenedWhereItsLimbsEnd) {
  const ExampleShape shape = example_shape("teddy");
  const Suggestion best = suggest_marks(shape.vertices, shape.faces).front();
  EXPECT_GE(best.openings.size(), 4u);
  EXPECT_EQ(best.times.size(), best.openings.size()) << "every opening has its time";
}

TEST(Suggest, ABallIsOpenedAtOppositePlaces) {
  const MeshArrays arrays = ball(50.0);
  const Suggestion best = suggest_marks(arrays.vertices, arrays.faces).front();
  ASSERT_EQ(best.openings.size(), 2u);
  EXPECT_GT((best.openings[0].at - best.openings[1].at).norm(), 90.0);
}

TEST(Suggest, AMeshThatCannotBeKnitIsRefusedWithItsProblems) {
  const MeshArrays arrays = side_by_side(ball(50.0, 3), ball(50.0, 3), {200.0, 0.0, 0.0});
  try {
    suggest_marks(arrays.vertices, arrays.faces);
    FAIL() << "two pieces";
  } catch (const NotKnittable& refused) {
    EXPECT_NE(find_problem(refused.problems(), "several-components"), nullptr);
  }
}

TEST(Suggest, ABallOfAFewStitchesIsRefused) {
  const MeshArrays arrays = ball(6.0, 3);
  try {
    suggest_marks(arrays.vertices, arrays.faces);
    FAIL() << "no opening fits";
  } catch (const NotKnittable& refused) {
    EXPECT_NE(find_problem(refused.problems(), "nothing-to-suggest"), nullptr);
  }
}

}  // namespace
}  // namespace meshknit
